/// Bounding volume hierarchy that finds overlapping boxes; touching counts as overlap. Boxes are
/// sorted along a Hilbert curve and packed in groups of four, layer by layer. Four boxes are tested
/// together. Building and pair searches run on all allowed threads; the results do not depend on
/// the number of threads. The depth depends on the number of boxes only. Hence equal boxes increase
/// the number of pairs, but not the depth. (MedianTree serves nearest-neighbor queries.) Cost: O(n)
/// to build for boxes in distinct places; 40 bytes per box. Reference: Kamel & Faloutsos, "On
/// packing R-trees", CIKM 1993.
#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/search/box_quad.h"
#include "geometry/search/float_box.h"
#include "geometry/search/simplex_links.h"
#include "transformesh/mesh.h"

namespace transformesh {

class Bvh {
 public:
  Bvh() = default;
  explicit Bvh(std::span<const FloatBox> boxes);
  /// Builds a tree of the boxes of faces: box i contains the face with index faces[i]. Boxes of two
  /// faces count as disjoint if `links` prove that the faces meet only in shared vertices and edges
  /// (simplex_links.h).
  Bvh(std::span<const FloatBox> boxes, const SimplexLinks& links, std::span<const Index> faces);
  /// Builds a tree of the bounding boxes of all faces. Box i contains face i.
  explicit Bvh(const Mesh& mesh);

  /// Divides the boxes into groups. Boxes of the same group count as disjoint in later calls of
  /// visit_pairs(). The group no_index means no group.
  void set_groups(std::span<const Index> group_of_box);

  using Pair = std::pair<Index, Index>;
  /// Type of the first argument of visit_pairs(). It is called once, before pairs are visited, with
  /// the number of lists. Then visit(list, pairs) is called for all pairs of overlapping boxes with
  /// first < second, in portions. Several lists are processed concurrently. The portions of one
  /// list are visited sequentially, in an order that is always the same.
  using Prepare = std::function<void(std::size_t lists)>;
  using VisitPairs = std::function<void(std::size_t list, std::span<const Pair> pairs)>;
  void visit_pairs(const Prepare& prepare, const VisitPairs& visit) const;

  /// Calls visit(i) for each box that overlaps `box`, until `visit` returns false. `links` are the
  /// link boxes of the face in `box` (simplex_links.h). If they are given, boxes of faces that
  /// certainly meet this face only in shared vertices and edges are skipped.
  void visit_overlaps(const FloatBox& box, const std::function<bool(Index)>& visit,
                      const LinkBoxes* links = nullptr) const;
  /// Calls visit(i) once for each box that overlaps at least one box of `other`. Cost: O(log n) for
  /// each of these boxes on usual data, however many boxes of `other` overlap it.
  void visit_overlaps(const Bvh& other, const std::function<void(Index)>& visit) const;
  bool empty() const { return order_.empty(); }

 private:
  class PairSearch;
  template <class Mask, class Visit>
  void descend(const Mask& mask, const Visit& visit) const;
  void add_links(const SimplexLinks& links, std::span<const Index> faces);
  Index add_common_links(std::span<const Index> rows);
  /// Returns the link boxes that all faces in box `place` of a layer have in common, or null. Link
  /// boxes bound the directions from a corner or edge into faces (simplex_links.h).
  const LinkBoxes* links_of(std::size_t layer, std::size_t place) const;

  std::vector<Index> order_;  ///< indices of the boxes in tree order: four for each quad of layer 0
  /// Layers of quads (four boxes), from the leaves up; quad 4q + c of a layer is in box c of quad q
  /// above.
  std::vector<std::vector<BoxQuad>> layers_;
  /// For each box of each layer, the row in `links_` with the link boxes (simplex_links.h) that all
  /// faces in the box have in common, or no_index. Empty if there are no link boxes.
  std::vector<std::vector<Index>> link_rows_;
  std::vector<LinkBoxes> links_;
  /// For each box of each layer, the common group of all boxes in it, or no_index. Empty if there
  /// are no groups.
  std::vector<std::vector<GroupQuad>> groups_;
};

}  // namespace transformesh
