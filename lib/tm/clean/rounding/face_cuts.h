/// Splits faces of a mesh at points that are close to them (paper 4.3). A point on an edge splits
/// all faces of the edge, so that what is closed stays closed. Equal positions are one point. Cost:
/// O(n) for n faces, and that of FaceSplitter for each face with points. Deterministic.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tm/clean/intersect/welded_mesh.h"
#include "tm/clean/stitch/assemble.h"

namespace transformesh {

/// An edge as its points, the smaller one first.
using PointPair = std::array<Index, 2>;

inline PointPair edge_of(const Face& corners, std::size_t i) {
  const Index a = corners[i], b = corners[(i + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

class FaceCuts {
 public:
  /// `welded` is the welded mesh of the assembly. New positions are rounded to numbers of the type
  /// `coordinate`. Keeps references to both.
  FaceCuts(Assembly& assembly, const WeldedMesh& welded, Scalar coordinate);

  std::size_t faces() const { return corners_.size(); }
  /// The points at the corners of a face.
  const Face& corners(Index face) const { return corners_[face]; }
  const Vec3& position(Index point) const { return points_[point]; }
  Triangle triangle(Index face) const;

  /// Notes a point that is close to the edge, at that share of its length.
  void add_on_edge(const PointPair& edge, double share, Index point);
  /// Notes a point that is close to the interior of the face.
  void add_inside(Index face, Index point);
  /// A new point at which two edges pass each other. For the same edges it is always the same.
  Index point_between(const PointPair& first, const PointPair& second, const Vec3& position);
  /// Makes edges of the face from those edges of the other one of which both ends are noted there.
  void constrain(Index face, Index other);
  /// Splits all faces with points. Whole faces keep their order, and pieces follow. Points inside a
  /// face that are closer than the distance to another cut of it split that cut. To be called once.
  void split_faces(double distance);

 private:
  std::vector<std::pair<double, Index>> cuts_of(const PointPair& edge) const;
  std::vector<Index> chain_of(const PointPair& edge) const;
  std::set<Index> points_on(Index face) const;
  bool is_split(Index face) const;
  std::vector<Face> split(Index face, double distance) const;
  void add_vertices(const std::vector<Face>& pieces, const std::vector<Index>& rows);
  void replace_faces(std::vector<Face> faces, const std::vector<Index>& rows,
                     std::size_t first_piece);

  Assembly& assembly_;
  const WeldedMesh& welded_;
  const Scalar coordinate_;
  std::vector<Face> corners_;                             ///< the points of all faces
  std::vector<Vec3> points_;                              ///< of the welded mesh, then new ones
  std::map<PointPair, std::map<Index, double>> on_edge_;  ///< per edge: its points and their shares
  std::map<Index, std::set<Index>> inside_;               ///< per face: the points in its interior
  std::map<Index, std::set<PointPair>> constraints_;      ///< per face: the edges that it must have
  std::map<std::array<PointPair, 2>, Index> between_;     ///< the new point of two edges
};

}  // namespace transformesh
