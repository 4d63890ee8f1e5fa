#include "tm/geometry/bvh.h"

#include <algorithm>
#include <bit>

#include "tm/geometry/hilbert.h"
#include "tm/geometry/quad_overlap.h"
#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t quads_per_task = 1024;

/// More than can wait at once: each level leaves at most three quads waiting.
constexpr std::size_t stack_size = 64;

FloatBox united(const BoxQuad& quad) {
  FloatBox box = quad.box(0);
  for (int axis = 0; axis < 3; ++axis)
    for (int lane = 1; lane < 4; ++lane) {
      // In this order a comparison with the NaN of an unused box changes nothing.
      box.minimum[axis] = std::min(box.minimum[axis], quad.minimum[axis][lane]);
      box.maximum[axis] = std::max(box.maximum[axis], quad.maximum[axis][lane]);
    }
  return box;
}

/// Packs box_of(0) .. box_of(count - 1) four by four.
template <class BoxOf>
std::vector<BoxQuad> pack(std::size_t count, const BoxOf& box_of) {
  std::vector<BoxQuad> quads((count + 3) / 4);
  parallel_for(quads.size(), quads_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = 4 * first; i < 4 * last; ++i)
      quads[i / 4].set(i % 4, i < count ? box_of(i) : unused_box);
  });
  return quads;
}

}  // namespace

Bvh::Bvh(std::span<const FloatBox> boxes) : order_(hilbert_order(boxes)) {
  if (boxes.empty()) return;
  levels_.push_back(pack(boxes.size(), [&](std::size_t i) { return boxes[order_[i]]; }));
  while (levels_.back().size() > 1) {
    const std::vector<BoxQuad>& below = levels_.back();
    auto level = pack(below.size(), [&](std::size_t i) { return united(below[i]); });
    levels_.push_back(std::move(level));
  }
}

Bvh::Bvh(const Mesh& mesh) : Bvh(face_boxes(mesh)) {}

void Bvh::visit_overlaps(const FloatBox& box, const std::function<bool(Index)>& visit) const {
  if (empty()) return;
  struct Node {
    std::size_t level;
    std::size_t quad;
  };
  std::array<Node, stack_size> stack;
  std::size_t waiting = 0;
  stack[waiting++] = {levels_.size() - 1, 0};
  while (waiting > 0) {
    const auto [level, quad] = stack[--waiting];
    for (unsigned mask = overlap_mask(levels_[level][quad], box); mask != 0; mask &= mask - 1) {
      const std::size_t below = 4 * quad + static_cast<std::size_t>(std::countr_zero(mask));
      if (level > 0) {
        stack[waiting++] = {level - 1, below};
      } else if (!visit(order_[below])) {
        return;
      }
    }
  }
}

}  // namespace transformesh
