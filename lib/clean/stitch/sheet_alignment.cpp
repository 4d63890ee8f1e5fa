#include "clean/stitch/sheet_alignment.h"

#include <cstdlib>

namespace transformesh {

void SheetAlignment::add_edge(const std::map<Index, int>& sums) {
  const auto edge = static_cast<Index>(sums_.size());
  sums_.push_back(0);
  for (const auto& [sheet, sum] : sums)
    if (sum != 0) ends_[sheet].emplace_back(edge, sum);
}

void SheetAlignment::find_kinds() {
  std::map<std::vector<End>, Index> kinds;
  for (Index sheet = 0; sheet < ends_.size(); ++sheet) {
    const auto next = static_cast<Index>(kinds_.size());
    // A sheet that does not end at an edge of more than two faces has no links to other sheets. It
    // gets a kind (set of equivalent sheets) of its own.
    const Index kind =
        ends_[sheet].empty() ? next : kinds.emplace(ends_[sheet], next).first->second;
    if (kind == next) kinds_.emplace_back().ends = &ends_[sheet];
    kinds_[kind].sheets.push_back(sheet);
    kind_of_.push_back(kind);
  }
  kinds_at_.resize(sums_.size());
  for (Index kind = 0; kind < kinds_.size(); ++kind)
    for (const auto& [edge, sum] : *kinds_[kind].ends) kinds_at_[edge].emplace_back(kind, sum);
}

/// Adds the best link to kind `number` to the queue. A kind is a set of sheets with equal sums at
/// the same edges. The link leads to the lowest sheet of the kind that align() has not returned
/// yet. Does nothing if all sheets of the kind were returned.
void SheetAlignment::push(Index number) {
  Kind& kind = kinds_[number];
  if (kind.aligned == kind.sheets.size()) return;
  kind.best.sheet = kind.sheets[kind.aligned];
  steps_.push(kind.best);
}

/// Follows the links from a sheet of kind `from` to all kinds that have an edge in common with it.
/// A kind is a set of sheets with equal sums at the same edges. `is_reversed` is the final state of
/// the sheet.
void SheetAlignment::link(Index from, bool is_reversed) {
  if (std::exchange(kinds_[from].has_links[is_reversed ? 1 : 0], true)) return;
  std::map<Index, std::int64_t> agreements;
  for (const auto& [edge, sum] : *kinds_[from].ends)
    for (const auto& [kind, other_sum] : kinds_at_[edge])
      agreements[kind] -= std::int64_t{sum} * other_sum;
  for (const auto& [kind, agreement] : agreements) {
    Step& best = kinds_[kind].best;
    const Step step{std::abs(agreement), best.sheet, is_reversed != (agreement < 0)};
    if (!(best < step)) continue;
    best = step;
    push(kind);
  }
}

std::vector<Index> SheetAlignment::align(Index first, std::vector<char>& is_reversed) {
  std::vector<Index> group;
  if (kinds_[kind_of_[first]].aligned > 0) return group;
  kinds_[kind_of_[first]].best = {0, first, false};
  push(kind_of_[first]);
  while (!steps_.empty()) {
    const Step step = steps_.top();
    steps_.pop();
    const Index number = kind_of_[step.sheet];
    Kind& kind = kinds_[number];
    // Skip a link that was followed already, or that is weaker than another link to the same kind
    // of sheets found later.
    if (kind.best < step || step < kind.best) continue;
    ++kind.aligned;
    is_reversed[step.sheet] = step.is_reversed ? 1 : 0;
    group.push_back(step.sheet);
    push(number);
    link(number, step.is_reversed);
  }
  return group;
}

void SheetAlignment::sum_up(const std::vector<Index>& group, const std::vector<char>& is_reversed) {
  for (const Index sheet : group)
    for (const auto& [edge, sum] : ends_[sheet]) sums_[edge] = 0;
  for (const Index sheet : group)
    for (const auto& [edge, sum] : ends_[sheet]) sums_[edge] += is_reversed[sheet] ? -sum : sum;
}

std::int64_t SheetAlignment::agreement(Index sheet, bool is_reversed) const {
  std::int64_t agreement = 0;
  for (const auto& [edge, sum] : ends_[sheet]) {
    const std::int64_t own = is_reversed ? -sum : sum;
    agreement -= own * (sums_[edge] - own);
  }
  return agreement;
}

void SheetAlignment::reverse(Index sheet, bool was_reversed) {
  for (const auto& [edge, sum] : ends_[sheet]) sums_[edge] += was_reversed ? 2 * sum : -2 * sum;
}

}  // namespace transformesh
