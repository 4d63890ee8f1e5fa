#include "evolution/topology_change.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <set>

#include "mesh/disjoint_sets.h"

namespace transformesh {
namespace {

LabeledVolume volume_of(const ComponentState& state) { return {state.label, state.volume}; }

/// Returns the size of a component, rounded to 30 bits. So rounding errors do not decide which of
/// two equal bodies keeps its label.
double rounded_size(const ComponentState& state) {
  int exponent = 0;
  const double fraction = std::frexp(std::abs(state.volume), &exponent);
  return std::ldexp(std::round(std::ldexp(fraction, 30)), exponent - 30);
}

bool is_larger(const ComponentState& a, const ComponentState& b) {
  return rounded_size(a) > rounded_size(b);
}

class Search {
 public:
  Search(const LabeledStates& before, std::span<const ComponentState> after,
         std::span<const Seam> seams)
      : before_(before), after_(after), seams_(seams), is_used_(seams.size(), 0) {
    for (Index i = 0; i < after.size(); ++i)
      for (const long label : after[i].labels)
        if (before.contains(label)) parts_[label].push_back(i);
  }

  std::vector<Event> run() {
    for (Index i = 0; i < after_.size(); ++i) find_joined(i);
    for (const auto& [label, parts] : parts_) find_separated(label, parts);
    find_handles();
    return std::move(events_);
  }

 private:
  /// Finds the components that were joined to component `i`, so that their labels disappear. If two
  /// solids are joined, the event is a merge. If a solid and a cavity are joined, it is an opened
  /// cavity.
  void find_joined(Index i) {
    const ComponentState& now = after_[i];
    for (const long label : now.labels) {
      if (label == now.label || !before_.contains(label)) continue;
      const ComponentState& absorbed = before_.at(label);
      const auto keeper = before_.find(now.label);
      if (keeper == before_.end() || persists(label)) continue;
      const bool opens = absorbed.is_cavity != keeper->second.is_cavity;
      add(opens ? EventKind::cavity_opened : EventKind::merge,
          {volume_of(keeper->second), volume_of(absorbed)}, {volume_of(now)},
          joining_seam(i, label), now.extent);
    }
  }

  /// True if one of the components after the change has this label.
  bool persists(long label) const {
    return std::ranges::any_of(after_, [&](const auto& state) { return state.label == label; });
  }

  /// Finds the parts that separated from a component. One part keeps `label`; the others have new
  /// labels.
  void find_separated(long label, const std::vector<Index>& parts) {
    const ComponentState& whole = before_.at(label);
    for (const Index i : parts) {
      const ComponentState& part = after_[i];
      if (before_.contains(part.label) || *source_of(part) != label) continue;
      const auto rest =
          std::ranges::find_if(parts, [&](Index other) { return after_[other].label == label; });
      std::vector<LabeledVolume> now;
      if (rest != parts.end()) now.push_back(volume_of(after_[*rest]));
      now.push_back(volume_of(part));
      const bool closes = part.is_cavity && !whole.is_cavity;
      add(closes ? EventKind::cavity_closed : EventKind::split, {volume_of(whole)}, now,
          separating_seam(i, parts), part.extent);
    }
  }

  /// Returns a label from before the change: that of the largest component to which faces of the
  /// part belonged.
  std::optional<long> source_of(const ComponentState& part) const {
    std::optional<long> source;
    for (const long label : part.labels) {
      const auto found = before_.find(label);
      if (found == before_.end()) continue;
      if (!source || is_larger(found->second, before_.at(*source))) source = label;
    }
    return source;
  }

  /// Finds opened and closed handles. Merges and splits do not change the sum of the genus of the
  /// components involved, so that any difference is the number of handles.
  void find_handles() {
    DisjointSets groups(after_.size());
    for (const auto& [label, parts] : parts_)
      for (const Index part : parts) groups.join(parts.front(), part);
    for (Index group = 0; group < after_.size(); ++group)
      if (groups.find(group) == group) compare_genus(groups, group);
  }

  void compare_genus(DisjointSets& groups, Index group) {
    std::set<long> labels;
    std::vector<LabeledVolume> was, now;
    long change = 0;
    Index largest = group;
    for (Index i = 0; i < after_.size(); ++i) {
      if (groups.find(i) != group) continue;
      change += after_[i].genus;
      labels.insert(after_[i].labels.begin(), after_[i].labels.end());
      now.push_back(volume_of(after_[i]));
      if (is_larger(after_[i], after_[largest])) largest = i;
    }
    for (const long label : labels) {
      const auto found = before_.find(label);
      if (found == before_.end()) continue;
      change -= found->second.genus;
      was.push_back(volume_of(found->second));
    }
    const EventKind kind = change > 0 ? EventKind::handle_opened : EventKind::handle_closed;
    for (long i = 0; i < std::abs(change); ++i)
      add(kind, was, now, seam_where([&](const Seam& seam) {
            return std::ranges::any_of(seam.components,
                                       [&](Index part) { return groups.find(part) == group; });
          }),
          after_[largest].extent);
  }

  /// Returns the extent of the largest seam that satisfies the condition, and marks this seam as
  /// used. Prefers seams that no other event has used.
  std::optional<Extent> seam_where(const auto& condition) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < seams_.size(); ++i) {
      if (!condition(seams_[i])) continue;
      if (!found || (is_used_[*found] && !is_used_[i])) found = i;
    }
    if (!found) return std::nullopt;
    is_used_[*found] = 1;
    return seams_[*found].extent;
  }

  std::optional<Extent> joining_seam(Index component, long label) {
    return seam_where([&](const Seam& seam) {
      return seam.components.contains(component) && seam.labels.contains(label) &&
             seam.labels.size() > 1;
    });
  }

  /// Returns the place where a part separated: the midpoint between a seam of the part and a seam
  /// of another part, for the closest two such seams.
  std::optional<Extent> separating_seam(Index part, const std::vector<Index>& parts) {
    std::optional<Extent> best;
    double least = 0;
    for (std::size_t a = 0; a < seams_.size(); ++a) {
      if (!seams_[a].components.contains(part)) continue;
      for (std::size_t b = 0; b < seams_.size(); ++b) {
        if (!touches_other(seams_[b], part, parts)) continue;
        const Extent &one = seams_[a].extent, &other = seams_[b].extent;
        const double distance = (one.center - other.center).norm();
        if (best && distance >= least) continue;
        best = {(one.center + other.center) / 2, std::max(one.size, other.size)};
        least = distance;
      }
    }
    return best ? best
                : seam_where([&](const Seam& seam) { return seam.components.contains(part); });
  }

  static bool touches_other(const Seam& seam, Index part, const std::vector<Index>& parts) {
    return std::ranges::any_of(
        parts, [&](Index other) { return other != part && seam.components.contains(other); });
  }

  /// Adds an event. If there is no seam, for example because a part separated at a single vertex,
  /// `otherwise` gives the place.
  void add(EventKind kind, std::vector<LabeledVolume> was, std::vector<LabeledVolume> now,
           const std::optional<Extent>& seam, const Extent& otherwise) {
    const Extent& extent = seam ? *seam : otherwise;
    Event event;
    event.kind = kind;
    event.place = extent.center;
    event.size = seam ? extent.size : 0;
    event.before = std::move(was);
    event.after = std::move(now);
    events_.push_back(std::move(event));
  }

  const LabeledStates& before_;
  std::span<const ComponentState> after_;
  std::span<const Seam> seams_;
  std::vector<char> is_used_;
  /// For each label before the change, the components after it that have faces with this label.
  std::map<long, std::vector<Index>> parts_;
  std::vector<Event> events_;
};

/// Returns the label that a component inherits: among the labels of its faces that are not in
/// `taken`, that of the largest component before. Solids and cavities do not inherit from each
/// other. Empty if there is no such label.
std::optional<long> label_for(const ComponentState& state, const LabeledStates& before,
                              const std::set<long>& taken) {
  std::optional<long> best;
  for (const long label : state.labels) {
    const auto found = before.find(label);
    if (found == before.end() || taken.contains(label)) continue;
    const bool matches = found->second.is_cavity == state.is_cavity;
    if (matches && (!best || is_larger(found->second, before.at(*best)))) best = label;
  }
  return best;
}

}  // namespace

bool is_same_topology(const LabeledStates& before, std::span<const ComponentState> after) {
  std::set<long> labels;
  for (const ComponentState& state : after) {
    const auto found = before.find(state.label);
    if (state.labels.size() > 1 || found == before.end()) return false;
    if (found->second.genus != state.genus || !labels.insert(state.label).second) return false;
  }
  return true;
}

void assign_labels(const LabeledStates& before, std::span<ComponentState> after, long& next_label) {
  std::vector<std::size_t> order(after.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return is_larger(after[a], after[b]); });
  std::set<long> taken;
  for (const std::size_t i : order) {
    const auto label = label_for(after[i], before, taken);
    after[i].label = label ? *label : next_label++;
    taken.insert(after[i].label);
  }
}

std::vector<Event> find_events(const LabeledStates& before, std::span<const ComponentState> after,
                               std::span<const Seam> seams) {
  return Search(before, after, seams).run();
}

}  // namespace transformesh
