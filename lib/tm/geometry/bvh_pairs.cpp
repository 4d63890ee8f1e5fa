#include <algorithm>
#include <bit>

#include "tm/geometry/bvh.h"
#include "tm/geometry/quad_overlap.h"
#include "tm/geometry/sort_pairs.h"
#include "tm/support/parallel.h"

namespace transformesh {
namespace {

using Pair = Bvh::Pair;
using Level = std::vector<BoxQuad>;

/// Enough tasks to keep all threads busy to the end. Their number does not depend on the threads.
constexpr std::size_t task_count = 1024;
constexpr std::size_t pairs_at_once = 1024;
constexpr std::size_t most_of_quads = 16;

/// Two quads of one level whose pairs are wanted. For the pairs inside a quad it is named twice.
struct Task {
  std::size_t level;
  Index first;
  Index second;
};

}  // namespace

/// Descends two trees at once, level by level. The trees may be one and the same.
class Bvh::PairSearch {
 public:
  PairSearch(const Bvh& here, const Bvh& there)
      : here_(here),
        there_(there),
        is_self_(&here == &there),
        has_links_(!here.links_.empty() && !there.links_.empty()) {}

  void run(const Prepare& prepare, const VisitPairs& visit) const {
    std::vector<Task> tasks = first_tasks();
    while (!tasks.empty() && tasks.size() < task_count && tasks[0].level > 0)
      tasks = refined(tasks);
    prepare(tasks.size());
    parallel_for(tasks.size(), 1, [&](std::size_t first, std::size_t last) {
      std::vector<Pair> pairs;
      pairs.reserve(pairs_at_once + most_of_quads);
      for (std::size_t i = first; i < last; ++i) {
        descend(tasks[i], pairs, [&] { visit(i, pairs); });
        visit(i, pairs);
        pairs.clear();
      }
    });
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
      const Index i = 4 * task.first + bit / 4, j = 4 * task.second + bit % 4;
      if (has_links_ && are_apart(here_.links_of(task.level, i), there_.links_of(task.level, j)))
        continue;
      visit(i, j);
    }
  }

  std::vector<Task> refined(const std::vector<Task>& tasks) const {
    std::vector<Task> result;
    for (const Task& task : tasks)
      for_each_overlap(task, [&](Index i, Index j) { result.push_back({task.level - 1, i, j}); });
    return result;
  }

  // Calls flush when enough pairs have come together.
  template <class Flush>
  void descend(const Task& task, std::vector<Pair>& pairs, const Flush& flush) const {
    if (task.level > 0) {
      for_each_overlap(task, [&](Index i, Index j) {
        descend({task.level - 1, i, j}, pairs, flush);
      });
      return;
    }
    for_each_overlap(task, [&](Index i, Index j) {
      Index first = here_.order_[i];
      Index second = there_.order_[j];
      if (is_self_ && second < first) std::swap(first, second);
      pairs.emplace_back(first, second);
    });
    if (pairs.size() < pairs_at_once) return;
    flush();
    pairs.clear();
  }

  const Bvh& here_;
  const Bvh& there_;
  bool is_self_;
  bool has_links_;
};

void Bvh::visit_pairs(const Prepare& prepare, const VisitPairs& visit) const {
  PairSearch(*this, *this).run(prepare, visit);
}

std::vector<Pair> Bvh::collect_pairs(const PairSearch& search, const Accept& accept) const {
  std::vector<std::vector<Pair>> lists;
  search.run([&](std::size_t count) { lists.resize(count); },
             [&](std::size_t list, std::span<const Pair> pairs) {
               for (const auto& [first, second] : pairs)
                 if (accept(first, second)) lists[list].emplace_back(first, second);
             });
  std::vector<Pair> pairs = joined(lists);
  sort_pairs(pairs, order_.size());
  return pairs;
}

std::vector<Pair> Bvh::overlapping_pairs(const Accept& accept) const {
  return collect_pairs(PairSearch(*this, *this), accept);
}

std::vector<Pair> Bvh::overlapping_pairs(const Bvh& other, const Accept& accept) const {
  return collect_pairs(PairSearch(*this, other), accept);
}

}  // namespace transformesh
