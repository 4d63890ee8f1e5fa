#include "clean/open/passages.h"

#include <array>
#include <map>
#include <set>
#include <utility>

#include "clean/exterior/angular_order.h"

namespace transformesh {
namespace {

// Returns the components that contain the piece of a halfedge, with the direction in which their
// face traverses the edge: true if it is forward.
std::set<std::pair<Index, bool>> components_at(const Arrangement& arrangement,
                                               const ComponentWinding& winding, Index halfedge) {
  const bool is_piece_forward = is_forward(arrangement.pieces, halfedge);
  std::set<std::pair<Index, bool>> result;
  for (const PieceSource& source : arrangement.sources_of(arrangement.pieces[halfedge / 3]))
    result.emplace(winding.component_of_face(source.face), is_piece_forward != source.reversed);
  return result;
}

}  // namespace

Passages find_passages(const Arrangement& arrangement, const ComponentWinding& winding,
                       std::span<const Index> sorted) {
  std::map<Index, std::array<std::vector<std::size_t>, 2>> places;
  for (std::size_t i = 0; i < sorted.size(); ++i)
    for (const auto& [component, is_forward] : components_at(arrangement, winding, sorted[i]))
      places[component][is_forward ? 0 : 1].push_back(i);
  Passages result;
  for (const auto& [component, of_component] : places) {
    const auto& [forward, backward] = of_component;
    if (forward.size() == 1 && backward.size() == 1)
      result.single.push_back({component, forward[0], backward[0]});
    if (forward.size() > 1 && backward.size() > 1) result.multiple.push_back(component);
  }
  return result;
}

std::optional<FrontAndBack> sides_of(std::span<const Index> sorted, const Passage& one,
                                     const Passage& other) {
  // In angular order, the pieces between the forward piece of `other` and its backward piece are in
  // front of `other`.
  const std::size_t n = sorted.size();
  const auto from_other = [&](std::size_t p) { return (p + n - other.forward) % n; };
  const std::size_t end = from_other(other.backward), backward = from_other(one.backward);
  const bool forward_is = from_other(one.forward) < end;
  const bool backward_is = 0 < backward && backward <= end;
  if (forward_is == backward_is) return std::nullopt;
  return FrontAndBack{sorted[forward_is ? one.forward : one.backward] / 3,
                      sorted[forward_is ? one.backward : one.forward] / 3};
}

}  // namespace transformesh
