/// Certifies that all points of a triangle are within a distance of a surface, by projection.
///
/// The faces around a seed are projected onto the plane of the triangle. Starting from the seed,
/// faces are collected across edges that meet the triangle in the projection. The boundary of the
/// collected faces thus does not meet the triangle. Then all points of the triangle are covered
/// equally often, counted with the orientation of the faces (the degree of the projection). If this
/// number is not zero, each point of the triangle is the projection of a point of the surface. The
/// distance of both points is a convex function on each face. It is largest at a corner of the part
/// of the face over the triangle. The certificate may not be found if the surface folds or ends,
/// but it is never wrong. Cost: O(number of faces over the triangle).
#pragma once

#include <cstdint>
#include <vector>

#include "remesh/guards/triangle_axes.h"

namespace transformesh {

class ProjectedFaces {
 public:
  /// Keeps a reference to the mesh. `opposites` are its opposite halfedges. If `stops_at_corners`,
  /// edges that meet the triangle only in a common corner are not crossed. The boundary of the
  /// collected faces then meets the triangle only in corners, and all other points are covered
  /// equally often. Use this for meshes with vertices of high valence: otherwise all faces at such
  /// a corner are collected, and the certificate is rarely found.
  ProjectedFaces(const Mesh& mesh, std::vector<Index> opposites, bool stops_at_corners = false);

  /// True if at most `most_faces` faces around the seed certify the triangle.
  bool covers(const Triangle& triangle, Index seed, double squared_limit, std::size_t most_faces);

 private:
  using Place = TriangleAxes::Place;
  using Places = std::array<Place, 3>;

  static bool may_meet(const Place& from, const Place& to);
  static bool meets_only_corner(const Triangle& triangle, const Vec3& end, const Place& other);
  static bool is_within(const Places& face, double squared_limit);
  static int turns_around_middle(const Place& from, const Place& to);

  const Mesh& mesh_;
  std::vector<Index> opposites_;
  bool stops_at_corners_;
  std::uint32_t stamp_ = 0;
  /// For each face the number of the last search that visited it.
  std::vector<std::uint32_t> stamps_;
  std::vector<Index> found_;
};

}  // namespace transformesh
