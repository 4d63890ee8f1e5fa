#include "views/color/chart_packing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace transformesh {
namespace {

/// Widths of the texture that are tried, relative to the side of a square with the total area of
/// all boxes.
constexpr std::array widths{1.02, 1.1, 1.2, 1.35, 1.5};

int up_to_multiple(int value) { return (value + 3) / 4 * 4; }

/// Packs the boxes into a texture of this width. `order` lists the indices of boxes, the highest
/// box first.
Packing pack(std::span<const Eigen::Vector2i> sizes, std::span<const std::size_t> order,
             int width) {
  Packing packing{std::vector<Eigen::Vector2i>(sizes.size()), width, 0};
  Eigen::Vector2i next(0, 0);
  int shelf = 0;
  for (const std::size_t i : order) {
    if (next.x() + sizes[i].x() > packing.width) next = {0, next.y() + shelf}, shelf = 0;
    packing.places[i] = next;
    next.x() += sizes[i].x();
    shelf = std::max(shelf, sizes[i].y());
  }
  packing.height = up_to_multiple(next.y() + shelf);
  return packing;
}

double area_of(const Packing& packing) {
  return static_cast<double>(packing.width) * packing.height;
}

}  // namespace

Packing pack_boxes(std::span<const Eigen::Vector2i> sizes) {
  double area = 0;
  int widest = 0;
  for (const Eigen::Vector2i& size : sizes) {
    area += static_cast<double>(size.x()) * size.y();
    widest = std::max(widest, size.x());
  }
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a].y() > sizes[b].y(); });
  Packing best;
  for (const double factor : widths) {
    const int side = static_cast<int>(factor * std::sqrt(area)) + 1;
    Packing next = pack(sizes, order, up_to_multiple(std::max(side, widest)));
    if (best.width == 0 || area_of(next) < area_of(best)) best = std::move(next);
  }
  return best;
}

}  // namespace transformesh
