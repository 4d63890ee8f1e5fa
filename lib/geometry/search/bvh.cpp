#include "geometry/search/bvh.h"

#include <algorithm>
#include <bit>

#include "geometry/search/hilbert.h"
#include "geometry/search/quad_overlap.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t quads_per_task = 1024;  ///< affects time only

/// Number of quads (nodes of four boxes) that fit on the stack of a traversal. The tree has at most
/// 16 layers, and each layer leaves at most three quads on the stack.
constexpr std::size_t stack_size = 64;

FloatBox united(const BoxQuad& quad) {
  FloatBox box = quad.box(0);
  for (int axis = 0; axis < 3; ++axis)
    for (int lane = 1; lane < 4; ++lane) {
      // The order of arguments matters: if the second argument is NaN, std::min returns the first.
      box.min()[axis] = std::min(box.min()[axis], quad.minimum[axis][lane]);
      box.max()[axis] = std::max(box.max()[axis], quad.maximum[axis][lane]);
    }
  return box;
}

/// Packs `count` boxes in quads of four. `box_of(i)` returns box i.
template <class BoxOf>
std::vector<BoxQuad> pack(std::size_t count, const BoxOf& box_of) {
  std::vector<BoxQuad> quads((count + 3) / 4);
  parallel_for(quads.size(), quads_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = 4 * first; i < 4 * last; ++i)
      quads[i / 4].set(i % 4, i < count ? box_of(i) : unused_box());
  });
  return quads;
}

}  // namespace

Bvh::Bvh(std::span<const FloatBox> boxes) : order_(hilbert_order(boxes)) {
  if (boxes.empty()) return;
  layers_.push_back(pack(boxes.size(), [&](std::size_t i) { return boxes[order_[i]]; }));
  while (layers_.back().size() > 1) {
    const std::vector<BoxQuad>& below = layers_.back();
    auto layer = pack(below.size(), [&](std::size_t i) { return united(below[i]); });
    layers_.push_back(std::move(layer));
  }
}

Bvh::Bvh(const Mesh& mesh) : Bvh(face_boxes(mesh)) {}

Bvh::Bvh(std::span<const FloatBox> boxes, const SimplexLinks& links, std::span<const Index> faces)
    : Bvh(boxes) {
  if (!links.empty()) add_links(links, faces);
}

void Bvh::add_links(const SimplexLinks& links, std::span<const Index> faces) {
  links_ = links.boxes;
  std::vector<Index> rows;
  rows.reserve(order_.size());
  for (const Index box : order_) rows.push_back(links.row_of[faces[box]]);
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
    std::vector<Index> above;
    for (std::size_t i = 0; i < rows.size(); i += 4)
      above.push_back(
          add_common_links(std::span(rows).subspan(i, std::min(rows.size() - i, std::size_t{4}))));
    link_rows_.push_back(std::exchange(rows, std::move(above)));
  }
}

Index Bvh::add_common_links(std::span<const Index> rows) {
  if (std::count(rows.begin(), rows.end(), no_index) > 0) return no_index;
  LinkBoxes common = links_[rows[0]];
  for (const Index row : rows) common = common_links(common, links_[row]);
  if (common[0].link == no_index) return no_index;
  links_.push_back(common);
  return static_cast<Index>(links_.size() - 1);
}

// Stores the groups of boxes for all layers of the tree. Unused boxes get the group of the first
// box of their quad, so that they do not affect the layers above.
void Bvh::set_groups(std::span<const Index> group_of_box) {
  groups_.clear();
  std::vector<Index> groups(order_.size());
  parallel_for(groups.size(), quads_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) groups[i] = group_of_box[order_[i]];
  });
  for (const auto& layer : layers_) {
    std::vector<GroupQuad> quads(layer.size());
    std::vector<Index> above(quads.size());
    parallel_for(quads.size(), quads_per_task, [&](std::size_t first, std::size_t last) {
      for (std::size_t q = first; q < last; ++q) {
        std::array<Index, 4>& group = quads[q].group;
        group.fill(groups[4 * q]);
        std::copy_n(&groups[4 * q], std::min(groups.size() - 4 * q, group.size()), group.data());
        const bool is_one = group[1] == group[0] && group[2] == group[0] && group[3] == group[0];
        above[q] = is_one ? group[0] : no_index;
      }
    });
    groups_.push_back(std::move(quads));
    groups = std::move(above);
  }
}

const LinkBoxes* Bvh::links_of(std::size_t layer, std::size_t place) const {
  const Index row = link_rows_.empty() ? no_index : link_rows_[layer][place];
  return row == no_index ? nullptr : &links_[row];
}

/// Enters the boxes for which mask(layer, quad) has a bit, and calls visit(i) for these boxes in
/// layer 0 until `visit` returns false.
template <class Mask, class Visit>
void Bvh::descend(const Mask& mask, const Visit& visit) const {
  if (empty()) return;
  struct Node {
    std::size_t layer;
    std::size_t quad;
  };
  std::array<Node, stack_size> stack;
  std::size_t waiting = 0;
  stack[waiting++] = {layers_.size() - 1, 0};
  while (waiting > 0) {
    const auto [layer, quad] = stack[--waiting];
    for (unsigned left = mask(layer, quad); left != 0; left &= left - 1) {
      const std::size_t below = 4 * quad + static_cast<std::size_t>(std::countr_zero(left));
      if (layer > 0) {
        stack[waiting++] = {layer - 1, below};
      } else if (!visit(order_[below])) {
        return;
      }
    }
  }
}

void Bvh::visit_overlaps(const FloatBox& box, const std::function<bool(Index)>& visit,
                         const LinkBoxes* links) const {
  const auto mask = [&](std::size_t layer, std::size_t quad) {
    unsigned overlaps = overlap_mask(layers_[layer][quad], box);
    for (unsigned lane = 0; links != nullptr && lane < 4; ++lane)
      if ((overlaps >> lane & 1) != 0 && are_apart(links, links_of(layer, 4 * quad + lane)))
        overlaps &= ~(1U << lane);
    return overlaps;
  };
  descend(mask, visit);
}

void Bvh::visit_overlaps(const Bvh& other, const std::function<void(Index)>& visit) const {
  const auto mask = [&](std::size_t layer, std::size_t quad) {
    unsigned overlaps = 0;
    for (unsigned lane = 0; lane < 4; ++lane)
      other.visit_overlaps(layers_[layer][quad].box(lane), [&](Index) {
        overlaps |= 1U << lane;
        return false;
      });
    return overlaps;
  };
  descend(mask, [&](Index i) {
    visit(i);
    return true;
  });
}

}  // namespace transformesh
