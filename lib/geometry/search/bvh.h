/// A bounding volume hierarchy that finds overlapping boxes; touching counts as overlap. Boxes are
/// packed four by four in the order of a Hilbert curve, in layers, and four are tested at
/// once. Building and pair searches run on all allowed threads;
/// results do not depend on their number. Every layer is as shallow as counting allows, whatever
/// the boxes: many equal boxes cost pairs, not depth. (MedianTree serves nearest queries.)
/// Cost: O(n) to build for boxes in distinct places, 40 bytes per box.
/// Reference: Kamel & Faloutsos, "On packing R-trees", CIKM 1993.
#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/search/box_quad.h"
#include "geometry/search/float_box.h"
#include "geometry/search/simplex_links.h"
#include "mesh/mesh.h"

namespace transformesh {

class Bvh {
 public:
  Bvh() = default;
  explicit Bvh(std::span<const FloatBox> boxes);
  /// Box i is that of a face with the links of face faces[i]: boxes of faces that are apart in a
  /// link that they have in common count as apart from now on.
  Bvh(std::span<const FloatBox> boxes, const SimplexLinks& links, std::span<const Index> faces);
  /// Box i is that of face i.
  explicit Bvh(const Mesh& mesh);

  /// Boxes of one group, which is a number or no_index for none, count as apart from now on.
  void set_groups(std::span<const Index> group_of_box);

  using Pair = std::pair<Index, Index>;
  using Accept = std::function<bool(Index, Index)>;
  /// All pairs of overlapping boxes with first < second that pass `accept`, sorted. `accept` is
  /// called in no particular order, and from several threads at once.
  std::vector<Pair> overlapping_pairs(const Accept& accept) const;
  /// All pairs (box here, box there), likewise.
  std::vector<Pair> overlapping_pairs(const Bvh& other, const Accept& accept) const;

  /// Calls visit(list, pairs) for all pairs of overlapping boxes, some at a time, several lists at
  /// once; the pairs of one list come one after the other, and always in the same order. Before
  /// that, it calls prepare with the number of lists.
  using Prepare = std::function<void(std::size_t lists)>;
  using VisitPairs = std::function<void(std::size_t list, std::span<const Pair> pairs)>;
  void visit_pairs(const Prepare& prepare, const VisitPairs& visit) const;

  /// Calls visit(i) for every box that overlaps `box`, until it returns false. Those that are apart
  /// from it in a link are left out.
  void visit_overlaps(const FloatBox& box, const std::function<bool(Index)>& visit,
                      const LinkBoxes* links = nullptr) const;
  bool empty() const { return order_.empty(); }

 private:
  class PairSearch;
  std::vector<Pair> collect_pairs(const PairSearch& search, const Accept& accept) const;
  void add_links(const SimplexLinks& links, std::span<const Index> faces);
  Index add_common_links(std::span<const Index> rows);
  /// Of box `place` of a layer.
  const LinkBoxes* links_of(std::size_t layer, std::size_t place) const;

  std::vector<Index> order_;                  ///< box ids, four for each quad of layer 0
  std::vector<std::vector<BoxQuad>> layers_;  ///< below box c of quad q lies quad 4q + c
  /// What the faces below each box have in common: rows of links_, or no_index; empty for no links.
  std::vector<std::vector<Index>> link_rows_;
  std::vector<LinkBoxes> links_;
  /// The group of all below each box of a quad, or no_index; empty for no groups.
  std::vector<std::vector<GroupQuad>> groups_;
};

}  // namespace transformesh
