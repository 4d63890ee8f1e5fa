/// The corners of a polygon that are not cut off yet, in a circle, while it is triangulated in one
/// projection.
#pragma once

#include <span>
#include <vector>

#include "io/polygons/planar_outline.h"
#include "mesh/mesh.h"

namespace transformesh {

class PolygonOutline {
 public:
  /// Keeps references. `points` are the projected positions.
  PolygonOutline(std::span<const Vec3> positions, std::span<const Index> vertices,
                 std::span<const Eigen::Vector2d> points);

  /// The corners in order.
  std::vector<std::uint32_t> corners() const;
  std::size_t size() const { return size_; }
  /// Whether corners of different vertices have the same point.
  bool has_twins() const;

  /// Cuts off corners until no two consecutive ones and no two neighbors of a corner have the same
  /// point.
  void remove_coincident();
  /// Cuts off the end of the edge from `corner` that has the smaller triangle, and `count - 1`
  /// corners behind.
  void cut_edge(std::uint32_t corner, std::size_t count);
  /// Cuts off all corners, as a fan from the first.
  void cut_fan();

  /// Appends a triangle without area in the projection.
  void add_flat(const CornerTriangle& triangle) { add(triangle, upright); }

  std::vector<CornerTriangle> triangles;  ///< that were cut off or added
  std::size_t folds = 0;    ///< of them: cut off at an edge or as a fan, with an area in space
  std::size_t upright = 0;  ///< of them: without area in the projection, with one in space

 private:
  void cut(std::uint32_t corner, std::size_t& kind);
  void add(const CornerTriangle& triangle, std::size_t& kind);
  bool is_there(std::uint32_t corner) const { return next_[corner] != corner; }
  double area(std::uint32_t corner) const;

  std::span<const Vec3> positions_;
  std::span<const Index> vertices_;
  std::span<const Eigen::Vector2d> points_;
  std::vector<std::uint32_t> next_, previous_;
  std::vector<std::uint32_t> place_;  ///< the lowest corner at the same point
  std::size_t size_;
  std::uint32_t first_ = 0;  ///< a corner that is there
};

/// Whether three points are on one line in space; exact.
bool is_collinear(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace transformesh
