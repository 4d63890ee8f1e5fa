#include <algorithm>
#include <bit>

#include "tm/geometry/bvh.h"
#include "tm/geometry/quad_overlap.h"
#include "tm/support/parallel.h"

namespace transformesh {
namespace {

using Pair = Bvh::Pair;
using Level = std::vector<BoxQuad>;

/// Enough tasks to keep all threads busy to the end. Their number does not depend on the threads.
constexpr std::size_t task_count = 1024;

/// Two quads of one level whose pairs are wanted. For the pairs inside a quad it is named twice.
struct Task {
  std::size_t level;
  Index first;
  Index second;
};

/// Sorts pairs whose first entries are below `bound`.
void sort_pairs(std::vector<Pair>& pairs, std::size_t bound) {
  if (pairs.size() < bound / 4) return std::sort(pairs.begin(), pairs.end());

  // Where pairs are many, a counting sort by the first entry leaves little to compare.
  std::vector<std::size_t> slot(bound + 1, 0);
  for (const Pair& pair : pairs) ++slot[pair.first + 1];
  for (std::size_t i = 1; i < slot.size(); ++i) slot[i] += slot[i - 1];
  std::vector<Pair> sorted(pairs.size());
  for (const Pair& pair : pairs) sorted[slot[pair.first]++] = pair;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < bound; ++i) {
    const std::size_t end = slot[i];
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(begin),
              sorted.begin() + static_cast<std::ptrdiff_t>(end));
    begin = end;
  }
  pairs.swap(sorted);
}

}  // namespace

/// Descends two trees at once, level by level. The trees may be one and the same.
class Bvh::PairSearch {
 public:
  PairSearch(const Bvh& here, const Bvh& there, const Accept& accept)
      : here_(here), there_(there), accept_(accept), is_self_(&here == &there) {}

  std::vector<Pair> run() const {
    std::vector<Task> tasks = first_tasks();
    while (!tasks.empty() && tasks.size() < task_count && tasks[0].level > 0)
      tasks = refined(tasks);

    // Each task has its own list, and lists are joined in the order of the tasks.
    std::vector<std::vector<Pair>> found(tasks.size());
    parallel_for(tasks.size(), 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) collect(tasks[i], found[i]);
    });
    std::size_t count = 0;
    for (const auto& list : found) count += list.size();
    std::vector<Pair> pairs;
    pairs.reserve(count);
    for (const auto& list : found) pairs.insert(pairs.end(), list.begin(), list.end());
    sort_pairs(pairs, here_.order_.size());
    return pairs;
  }

 private:
  /// Pairs of the roots. Of a higher tree the quads on the level of the other's root are taken.
  std::vector<Task> first_tasks() const {
    if (here_.empty() || there_.empty()) return {};
    const std::size_t level = std::min(here_.levels_.size(), there_.levels_.size()) - 1;
    std::vector<Task> tasks;
    for (Index i = 0; i < here_.levels_[level].size(); ++i)
      for (Index j = 0; j < there_.levels_[level].size(); ++j) tasks.push_back({level, i, j});
    return tasks;
  }

  /// Calls visit(box here, box there), as places in their level, for the overlaps of a task.
  template <class Visit>
  void for_each_overlap(const Task& task, const Visit& visit) const {
    const BoxQuad& first = here_.levels_[task.level][task.first];
    const BoxQuad& second = there_.levels_[task.level][task.second];
    unsigned mask = overlap_mask(first, second);
    const bool is_same = is_self_ && task.first == task.second;
    if (is_same) mask &= task.level == 0 ? 0x08ceU : 0x8cefU;  // j > i, or j >= i
    for (; mask != 0; mask &= mask - 1) {
      const auto bit = static_cast<Index>(std::countr_zero(mask));
      visit(4 * task.first + bit / 4, 4 * task.second + bit % 4);
    }
  }

  std::vector<Task> refined(const std::vector<Task>& tasks) const {
    std::vector<Task> result;
    for (const Task& task : tasks)
      for_each_overlap(task, [&](Index i, Index j) { result.push_back({task.level - 1, i, j}); });
    return result;
  }

  void collect(const Task& task, std::vector<Pair>& found) const {
    if (task.level > 0) {
      for_each_overlap(task, [&](Index i, Index j) { collect({task.level - 1, i, j}, found); });
      return;
    }
    for_each_overlap(task, [&](Index i, Index j) {
      Index first = here_.order_[i];
      Index second = there_.order_[j];
      if (is_self_ && second < first) std::swap(first, second);
      if (accept_(first, second)) found.emplace_back(first, second);
    });
  }

  const Bvh& here_;
  const Bvh& there_;
  const Accept& accept_;
  bool is_self_;
};

std::vector<Pair> Bvh::overlapping_pairs(const Accept& accept) const {
  return PairSearch(*this, *this, accept).run();
}

std::vector<Pair> Bvh::overlapping_pairs(const Bvh& other, const Accept& accept) const {
  return PairSearch(*this, other, accept).run();
}

}  // namespace transformesh
