#include "clean/open/patch_numbers.h"

#include <algorithm>
#include <cmath>

namespace transformesh {
namespace {

/// Winding numbers whose difference is smaller than this count as equal. Lengths and areas whose
/// relative difference is smaller than this count as equal.
constexpr double number_rounding = 1e-9;

double rounded_number(double number) { return std::floor(number + 0.5 + number_rounding); }

/// Returns the distance of a number from the nearest value at which it would be rounded otherwise.
double margin_of(double number) {
  return std::max(0.0, 0.5 - std::abs(number - rounded_number(number)));
}

}  // namespace

PatchNumbers::PatchNumbers(const CutPatches& patches, ComponentWinding& winding,
                           OwnNumbers& own_numbers)
    : patches_(patches), winding_(winding) {
  for (const Index own : patches.self_intersecting) {
    std::vector<Index> names;
    std::vector<const std::vector<Index>*> lists;
    for (const auto& [patch, members] : patches.pieces)
      if (component(patch) == own) {
        names.push_back(patch);
        lists.push_back(&members);
      }
    const std::vector<NumberBounds> bounds = own_numbers.bound(own, lists);
    for (std::size_t i = 0; i < names.size(); ++i) own_bounds_[names[i]] = bounds[i];
  }
}

PatchNumbers::Number PatchNumbers::hiding(Index patch) {
  is_by_winding_ = false;
  const int count = count_others(patch) + count_own(patch);
  return {count, is_by_winding_};
}

// A patch of coincident faces is hidden by each component that intersects one of their components.
int PatchNumbers::count_others(Index patch) {
  std::set<Index> others;
  for (const Index own : winding_.components_of(patches_.pieces.at(patch).front()))
    if (const auto found = patches_.intersecting.find(own); found != patches_.intersecting.end())
      others.insert(found->second.begin(), found->second.end());
  others.erase(component(patch));
  return static_cast<int>(std::count_if(others.begin(), others.end(),
                                        [&](Index other) { return is_behind(patch, other); }));
}

// A patch that is behind a component along their curves can extend beyond the component's border or
// through its holes to places far from it. Hence curves alone decide only if the component is at
// least as large as the patch. A patch in faces of the component is behind them if they have the
// opposite direction, because the front of the patch is there.
bool PatchNumbers::is_behind(Index patch, Index other) {
  if (component(patch) == ComponentWinding::closed_part && !winding_.is_body(other)) return false;
  const std::vector<Index>& pieces = patches_.pieces.at(patch);
  if (const auto curves = patches_.curves.find({patch, other}); curves != patches_.curves.end()) {
    const auto& [front, behind] = curves->second;
    if (behind <= (1 + number_rounding) * front) return false;
    if (winding_.area_of(other) >= (1 - number_rounding) * winding_.area_of(pieces)) return true;
  } else if (const auto is_reverse = winding_.is_reverse_of(pieces, other)) {
    return *is_reverse;
  }
  return round(winding_.median(other, pieces)) > 0;
}

// Returns how many other parts of the patch's own component hide the patch: its winding number less
// that of visible patches.
int PatchNumbers::count_own(Index patch) {
  const Index own = component(patch);
  if (!patches_.self_intersecting.contains(own)) return 0;
  const double shift = winding_.on_itself(own);
  const auto& [low, high] = own_bounds_.at(patch);
  const double rounded = rounded_number(low - shift);
  if (!std::isfinite(low) || rounded != rounded_number(high - shift))
    return round(winding_.median(own, patches_.pieces.at(patch)) - shift);
  is_by_winding_ = true;
  by_bounds_.push_back({std::min(margin_of(low - shift), margin_of(high - shift)), shift, patch});
  return static_cast<int>(rounded);
}

int PatchNumbers::round(double number) {
  is_by_winding_ = true;
  least_margin_ = std::min(least_margin_, margin_of(number));
  return static_cast<int>(rounded_number(number));
}

// Computes the winding numbers of the patches that could have the least margin.
double PatchNumbers::least_margin() {
  std::sort(by_bounds_.begin(), by_bounds_.end(),
            [](const auto& a, const auto& b) { return a.margin < b.margin; });
  for (const auto& [margin, shift, patch] : by_bounds_) {
    if (margin >= least_margin_) break;
    round(winding_.median(component(patch), patches_.pieces.at(patch)) - shift);
  }
  return least_margin_;
}

}  // namespace transformesh
