#include "shapes/pinch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/elementary/trigonometric.h"

namespace transformesh::shapes {
namespace {

using std::numbers::pi;

/// Joins rings of `around` vertices from the lower pole to the upper one.
class PinchBuilder {
 public:
  PinchBuilder(std::size_t around, std::size_t rings_below)
      : around_(around), rings_below_(rings_below) {}

  Mesh build() {
    add_lower_half();
    add_opposites();
    add_caps();
    for (std::size_t ring = 0; ring + 1 < 2 * rings_below_; ++ring) add_strip(ring);
    return std::move(mesh_);
  }

 private:
  // The lower half is a surface of revolution. Its profile is half a loop of a lemniscate, which
  // ends at the origin. The last ring stops short of the origin: its distance is half the length of
  // the faces that intersect there.
  void add_lower_half() {
    mesh_.positions.emplace_back(0, 0, -1.2);
    for (std::size_t ring = 1; ring <= rings_below_; ++ring) {
      const double t = pi / 2 * (1 - static_cast<double>(ring) / (rings_below_ + 0.5));
      const double radius = 1.2 * elementary::sin(t) * elementary::cos(t);
      for (std::size_t i = 0; i < around_; ++i) {
        const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(around_);
        mesh_.positions.emplace_back(radius * elementary::cos(angle),
                                     radius * elementary::sin(angle), -1.2 * elementary::sin(t));
      }
    }
  }

  // Appends the rings of the lower half, reflected in the origin.
  void add_opposites() {
    for (std::size_t ring = rings_below_; ring-- > 0;)
      for (std::size_t i = 0; i < around_; ++i)
        mesh_.positions.emplace_back(-mesh_.positions[vertex(ring, i)]);
    mesh_.positions.emplace_back(-mesh_.positions[0]);
  }

  void add_caps() {
    const auto top = static_cast<Index>(mesh_.positions.size() - 1);
    for (std::size_t i = 0; i < around_; ++i) {
      mesh_.faces.push_back({0, vertex(0, i + 1), vertex(0, i)});
      mesh_.faces.push_back(
          {top, vertex(2 * rings_below_ - 1, i), vertex(2 * rings_below_ - 1, i + 1)});
    }
  }

  void add_strip(std::size_t ring) {
    for (std::size_t i = 0; i < around_; ++i) {
      const Index low = vertex(ring, i);
      const Index low_right = vertex(ring, i + 1);
      const Index high = vertex(ring + 1, i);
      const Index high_right = vertex(ring + 1, i + 1);
      mesh_.faces.push_back({low, low_right, high_right});
      mesh_.faces.push_back({low, high_right, high});
    }
  }

  Index vertex(std::size_t ring, std::size_t i) const {
    return static_cast<Index>(1 + ring * around_ + i % around_);
  }

  std::size_t around_;
  std::size_t rings_below_;
  Mesh mesh_;
};

}  // namespace

Mesh pinch(std::size_t faces) {
  // Each ring has nine times as many vertices as there are rings, because a ring's vertices
  // determine the number of intersecting faces.
  const auto wanted = static_cast<double>(faces);
  const double rings_below = std::max(2.0, std::round(std::sqrt(wanted / 72)));
  const double around = std::max(3.0, std::round(wanted / (4 * rings_below)));
  return PinchBuilder(static_cast<std::size_t>(around), static_cast<std::size_t>(rings_below))
      .build();
}

}  // namespace transformesh::shapes
