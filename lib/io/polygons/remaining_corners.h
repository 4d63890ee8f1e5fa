/// The corners of a polygon that are left while triangles are cut off it, as a circular list. The
/// polygon is triangulated in one projection to a plane.
#pragma once

#include <span>
#include <vector>

#include "io/polygons/planar_outline.h"
#include "transformesh/mesh.h"

namespace transformesh {

class RemainingCorners {
 public:
  /// Keeps references. `positions` and `vertices` are the corners in space and their vertex
  /// indices. `points` are the projected positions.
  RemainingCorners(std::span<const Vec3> positions, std::span<const Index> vertices,
                   std::span<const Eigen::Vector2d> points);

  /// Returns the remaining corners in order.
  std::vector<std::uint32_t> corners() const;
  std::size_t size() const { return size_; }
  /// True if corners of different vertices have the same projection.
  bool has_twins() const;

  /// Cuts off corners until no two consecutive corners, and no two neighbors of a corner, coincide.
  void remove_coincident();
  /// Cuts off one end of the edge from `corner` to the next corner: the end whose triangle is
  /// smaller. Then cuts off the `count - 1` corners after it.
  void cut_edge(std::uint32_t corner, std::size_t count);
  /// Cuts off all corners as a triangle fan from the first corner.
  void cut_fan();

  /// Appends a triangle without area in the projection.
  void add_flat(const CornerTriangle& triangle) { add(triangle, upright); }

  std::vector<CornerTriangle> triangles;  ///< triangles that were cut off or added
  /// Number of triangles with an area in space that cut_edge() or cut_fan() cut off.
  std::size_t folds = 0;
  /// Number of triangles with an area in space, but not in the projection.
  std::size_t upright = 0;

 private:
  void cut(std::uint32_t corner, std::size_t& kind);
  void add(const CornerTriangle& triangle, std::size_t& kind);
  bool is_there(std::uint32_t corner) const { return next_[corner] != corner; }
  double area(std::uint32_t corner) const;

  std::span<const Vec3> positions_;
  std::span<const Index> vertices_;
  std::span<const Eigen::Vector2d> points_;
  std::vector<std::uint32_t> next_, previous_;
  /// For each corner, the lowest index of a corner at the same point.
  std::vector<std::uint32_t> place_;
  std::size_t size_;
  std::uint32_t first_ = 0;  ///< index of a remaining corner
};

}  // namespace transformesh
