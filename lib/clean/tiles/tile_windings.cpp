#include "clean/tiles/tile_windings.h"

#include <algorithm>
#include <limits>

#include "mesh/location_text.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Largest number of rays per box. A ray is of no use if it touches an edge. This happens only by
/// coincidence, so a second ray is rarely needed.
constexpr int rays_per_box = 4;

}  // namespace

TileWindings::TileWindings(const std::vector<Box>& boxes) : is_empty_(boxes.size(), 0) {
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    is_empty_[b] = boxes[b].isEmpty() ? 1 : 0;
    for (int i = 0; i < rays_per_box && !is_empty_[b]; ++i) {
      const Vec3 from = spread_point(boxes[b], i);
      Vec3 to = from;
      to[0] = std::numeric_limits<double>::infinity();
      rays_.push_back({from, b, AxisPath(from, to)});
    }
  }
  std::stable_sort(rays_.begin(), rays_.end(),
                   [](const Ray& a, const Ray& b) { return a.from.y() < b.from.y(); });
}

void TileWindings::add(const Triangle& t) {
  const double low = std::min({t[0].y(), t[1].y(), t[2].y()});
  const double high = std::max({t[0].y(), t[1].y(), t[2].y()});
  auto ray = std::lower_bound(rays_.begin(), rays_.end(), low,
                              [](const Ray& r, double y) { return r.from.y() < y; });
  for (; ray != rays_.end() && ray->from.y() <= high; ++ray) ray->path.add(t);
}

// Returns the start of a ray and its winding number. The winding number at infinity is 0, so the
// number at the start is minus the sum of the changes along the ray.
ReferencePoint TileWindings::of_box(std::size_t box) const {
  if (is_empty_[box]) return {};
  for (const Ray& ray : rays_) {
    if (ray.box != box) continue;
    if (const std::optional<int> change = ray.path.change()) return {ray.from, -*change};
  }
  const auto any =
      std::find_if(rays_.begin(), rays_.end(), [&](const Ray& ray) { return ray.box == box; });
  throw GoalError("rays along the x axis meet edges or corners near " + point_text(any->from) +
                  ": rotate the mesh slightly");
}

}  // namespace transformesh
