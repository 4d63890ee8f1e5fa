/// Splits one face at points on its edges and near its inside, into triangles that hang together as
/// the face does whatever the points are; how well shaped they are is told in extended precision.
/// Reference for constraints by flips: Sloan, "A fast algorithm for generating constrained Delaunay
/// triangulations", Computers & Structures 47(3), 1993.
/// Cost: O(n^2) for n points. Deterministic.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "tm/clean/rounding/wide_point.h"
#include "tm/geometry/predicates.h"
#include "tm/mesh/mesh.h"

namespace transformesh {

class FaceSplitter {
 public:
  /// `ids` name the corners. Points inside that are closer than `distance` to a cut go on it.
  FaceSplitter(const Triangle& triangle, const Face& ids, double distance);

  /// Point `id` on the edge from corner `edge` to the next, at that share of its length; in their
  /// order along the edge, and before all inside.
  void add_on_edge(std::size_t edge, double share, Index id);
  /// Nothing where the id is there already.
  void add_inside(const Vec3& position, Index id);
  /// Makes the segment between two of the points an edge, where flips can.
  void constrain(Index from_id, Index to_id);
  /// Flips other diagonals so that triangles are well shaped (Delaunay; of two diagonals that are
  /// alike that with the lowest id, so that equal points give equal triangles).
  void improve();
  /// As ids; what names one twice is left out.
  std::vector<Face> triangles() const;

 private:
  using PlanePoint = Eigen::Matrix<long double, 2, 1>;
  using Halfedges = std::map<std::pair<Index, Index>, Index>;  // by their ends: 3 * face + corner
  /// The two triangles at an edge: from a to b with c on its left and d on its right.
  struct Quad {
    Index a, b, c, d;
  };

  PlanePoint flat(const Vec3& position) const;
  long double height(const PlanePoint& point, Index from, Index to) const;
  long double cotangent(Index at, Index from, Index to) const;
  std::size_t face_around(const PlanePoint& point) const;
  Index add_vertex(const PlanePoint& position, Index id);
  void split_edge(Index halfedge, Index vertex);
  void split_face(std::size_t face, Index vertex);
  Index near_edge(std::size_t face, const PlanePoint& point, const Halfedges& halfedges) const;
  Halfedges find_halfedges() const;
  Quad quad_at(Index halfedge, Index across) const;
  bool is_convex(const Quad& quad) const;
  bool wants_flip(const Quad& quad) const;
  void flip(Index halfedge, Index across, const Quad& quad);
  bool flip_all();
  bool crosses(Index from, Index to, Index a, Index b) const;
  bool step_towards(Index from, Index to, std::size_t step);

  Triangle triangle_;
  double distance_;
  WidePoint x_axis_, y_axis_;
  std::vector<Index> ids_;
  std::vector<PlanePoint> positions_;
  std::array<Index, 3> last_ = {0, 1, 2};  ///< per edge: the last vertex added
  std::vector<Face> faces_;
  std::set<std::pair<Index, Index>> constrained_;
};

}  // namespace transformesh
