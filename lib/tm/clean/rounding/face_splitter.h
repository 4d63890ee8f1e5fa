/// Splits one face at points on its edges and near its interior, into triangles that are connected
/// as a triangulation of the face is, whatever the points are. Their shapes are compared in
/// extended precision. Reference for constraints by flips: Sloan, "A fast algorithm for generating
/// constrained Delaunay triangulations", Computers & Structures 47(3), 1993. Cost: O(n^2) for n
/// points. Deterministic.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <set>
#include <vector>

#include "tm/geometry/predicates.h"
#include "tm/mesh/mesh.h"

namespace transformesh {

/// A position in extended precision, for measures of parts that are as close as doubles are apart.
using WidePoint = Eigen::Matrix<long double, 3, 1>;

inline WidePoint wide(const Vec3& p) { return p.cast<long double>(); }

class FaceSplitter {
 public:
  /// `ids` name the corners. A point inside that is closer than `distance` to an edge between
  /// triangles splits that edge.
  FaceSplitter(const Triangle& triangle, const Face& ids, double distance);

  /// Adds a point on the edge from corner `edge` to the next, at that share of its length. Points
  /// of an edge are to be added in their order along it, and before all points inside.
  void add_on_edge(std::size_t edge, double share, Index id);
  /// Adds a point inside, unless its id is there already.
  void add_inside(const Vec3& position, Index id);
  /// Makes the segment between two of the points an edge, where flips can do that.
  void constrain(Index from_id, Index to_id);
  /// Flips other diagonals until they are Delaunay. Of two diagonals that are alike it takes that
  /// with the lowest id, so that equal points give equal triangles.
  void improve();
  /// The triangles by ids. Those that name one twice are left out.
  std::vector<Face> triangles() const;

 private:
  using PlanePoint = Eigen::Matrix<long double, 2, 1>;
  /// The halfedge 3 * face + corner from one vertex to another.
  using Halfedges = std::map<std::pair<Index, Index>, Index>;
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
  std::array<Index, 3> last_ = {0, 1, 2};  ///< per edge: the vertex that was added last
  std::vector<Face> faces_;
  std::set<std::pair<Index, Index>> constrained_;
};

}  // namespace transformesh
