// Finds the pairs of overlapping boxes in a bounding volume hierarchy, by a simultaneous descent
// into pairs of its boxes. Cost: O(n + k) for k pairs of usual boxes. Parallel; the lists of pairs
// do not depend on the number of threads.
#include <algorithm>
#include <cstdint>

#include "geometry/search/bvh.h"
#include "geometry/search/quad_overlap.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

using Pair = Bvh::Pair;
using Layer = std::vector<BoxQuad>;

/// Approximate number of tasks, independent of the number of threads. It is enough to keep all
/// threads busy until the end; more tasks cost time to prepare. A choice.
constexpr std::size_t task_count = 1024;
/// Number of pairs in a buffer that are processed together. Affects time only.
constexpr std::size_t pairs_at_once = 1024;
/// Largest number of pairs of boxes between two quads (of four boxes).
constexpr std::size_t most_of_quads = 16;

/// Two quads (nodes of four boxes) of a layer between which overlapping boxes are searched. Both
/// are the same quad for pairs within a quad.
struct Task {
  std::size_t layer;
  Index first;
  Index second;
};

/// Indices of two boxes of a layer, packed into one number, so that one addition increases both.
using PlacePair = std::uint64_t;
constexpr int place_bits = 32;  ///< number of bits of an index
constexpr PlacePair place_pair(Index first, Index second) {
  return PlacePair{second} << place_bits | first;
}
constexpr Index first_of(PlacePair places) { return static_cast<Index>(places); }
constexpr Index second_of(PlacePair places) { return static_cast<Index>(places >> place_bits); }

/// The pairs of boxes of two quads whose bits are set in a mask of turned_overlap_masks(). Only the
/// first `count` entries are valid.
struct NamedPairs {
  std::array<PlacePair, 4> places;
  std::size_t count;
};
constexpr auto make_named_pairs() {
  std::array<std::array<NamedPairs, 16>, 4> table{};
  for (Index turn = 0; turn < 4; ++turn)
    for (Index mask = 0; mask < 16; ++mask) {
      NamedPairs& named = table[turn][mask];
      for (Index i = 0; i < 4; ++i)
        if ((mask >> i & 1) != 0) named.places[named.count++] = place_pair(i, (i + turn) % 4);
    }
  return table;
}

constexpr auto named_pairs = make_named_pairs();

/// Masks that select the pairs of boxes to be tested, one for each mask of turned_overlap_masks().
/// `all_pairs` is for two different quads. `pairs_inside` is for a quad with itself, where each
/// pair is tested once. `different_inside` also excludes pairs of a box with itself.
constexpr std::array<unsigned, 4> all_pairs{15, 15, 15, 15};
constexpr std::array<unsigned, 4> pairs_inside{15, 15, 3, 0};
constexpr std::array<unsigned, 4> different_inside{0, 15, 3, 0};

/// Writes the pairs of overlapping boxes of two quads to `to`, and returns the end of the output.
/// Writes four pairs per mask, of which only the valid ones are kept. The inner loop has no
/// branches, because they would be unpredictable.
PlacePair* list_overlaps(const BoxQuad& first, const BoxQuad& second, PlacePair base,
                         const std::array<unsigned, 4>& counting, PlacePair* to) {
  const std::array<unsigned, 4> masks = turned_overlap_masks(first, second);
  for (std::size_t turn = 0; turn < 4; ++turn) {
    const NamedPairs& named = named_pairs[turn][masks[turn] & counting[turn]];
    for (std::size_t k = 0; k < 4; ++k) to[k] = base + named.places[k];
    to += named.count;
  }
  return to;
}

/// Buffer of pairs of boxes in layer 0, the lowest layer. It is processed when it is full.
class PlacePairs {
 public:
  PlacePairs() : places_(pairs_at_once + most_of_quads), end_(places_.data()) {}
  PlacePair* end() { return end_; }
  void set_end(PlacePair* end) { end_ = end; }
  bool is_full() const { return end_ - places_.data() >= std::ptrdiff_t{pairs_at_once}; }
  std::span<const PlacePair> take() {
    const std::span<const PlacePair> all(places_.data(), end_);
    end_ = places_.data();
    return all;
  }

 private:
  std::vector<PlacePair> places_;
  PlacePair* end_;
};

}  // namespace

/// Finds pairs of overlapping boxes by descending from the root to layer 0, layer by layer.
class Bvh::PairSearch {
 public:
  explicit PairSearch(const Bvh& tree) : tree_(tree) {}

  void run(const Prepare& prepare, const VisitPairs& visit) const {
    std::vector<Task> tasks;
    if (!tree_.empty()) tasks.push_back({tree_.layers_.size() - 1, 0, 0});
    while (!tasks.empty() && tasks.size() < task_count && tasks[0].layer > 0)
      tasks = refined(tasks);
    prepare(tasks.size());
    parallel_for(tasks.size(), 1, [&](std::size_t first, std::size_t last) {
      PlacePairs found;
      std::vector<Pair> pairs;
      for (std::size_t i = first; i < last; ++i) {
        const auto flush = [&] {
          name_boxes(found.take(), pairs);
          visit(i, pairs);
        };
        descend(tasks[i], found, flush);
        flush();
      }
    });
  }

 private:
  /// Clears the bits of pairs whose boxes belong to the same group. Returns false if no pair is
  /// left.
  bool leave_out_groups(const Task& task, std::array<unsigned, 4>& counting) const {
    const std::vector<GroupQuad>& groups = tree_.groups_[task.layer];
    const auto same = turned_group_masks(groups[task.first], groups[task.second]);
    for (std::size_t turn = 0; turn < 4; ++turn) counting[turn] &= ~same[turn];
    return (counting[0] | counting[1] | counting[2] | counting[3]) != 0;
  }

  /// Writes the pairs of overlapping boxes of a task, as indices in its layer. Returns the end of
  /// the output.
  PlacePair* list_overlaps_of(const Task& task, PlacePair* to) const {
    auto counting = task.first != task.second ? all_pairs
                    : task.layer == 0         ? different_inside
                                              : pairs_inside;
    if (!tree_.groups_.empty() && !leave_out_groups(task, counting)) return to;
    const std::vector<BoxQuad>& quads = tree_.layers_[task.layer];
    PlacePair* end = list_overlaps(quads[task.first], quads[task.second],
                                   place_pair(4 * task.first, 4 * task.second), counting, to);
    if (tree_.links_.empty()) return end;
    return std::remove_if(to, end, [&](PlacePair places) {
      return are_apart(tree_.links_of(task.layer, first_of(places)),
                       tree_.links_of(task.layer, second_of(places)));
    });
  }

  /// Returns the task on the layer below `layer` for a pair of overlapping boxes of `layer`.
  static Task task_below(std::size_t layer, PlacePair places) {
    const Index i = first_of(places), j = second_of(places);
    return {layer - 1, std::min(i, j), std::max(i, j)};
  }

  std::vector<Task> refined(const std::vector<Task>& tasks) const {
    std::vector<Task> result;
    std::array<PlacePair, most_of_quads> overlaps;
    for (const Task& task : tasks) {
      const PlacePair* end = list_overlaps_of(task, overlaps.data());
      for (const PlacePair* places = overlaps.data(); places != end; ++places)
        result.push_back(task_below(task.layer, *places));
    }
    return result;
  }

  // Descends from a task to the pairs of boxes of layer 0, and adds these pairs to `found`. Calls
  // `flush` whenever this buffer is full.
  template <class Flush>
  void descend(const Task& task, PlacePairs& found, const Flush& flush) const {
    if (task.layer == 0) {
      found.set_end(list_overlaps_of(task, found.end()));
      if (found.is_full()) flush();
      return;
    }
    std::array<PlacePair, most_of_quads> overlaps;
    const PlacePair* end = list_overlaps_of(task, overlaps.data());
    for (const PlacePair* places = overlaps.data(); places != end; ++places)
      descend(task_below(task.layer, *places), found, flush);
  }

  /// Converts indices in layer 0 to indices of the original boxes. The smaller index of each pair
  /// comes first.
  void name_boxes(std::span<const PlacePair> places, std::vector<Pair>& pairs) const {
    pairs.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Index first = tree_.order_[first_of(places[i])];
      const Index second = tree_.order_[second_of(places[i])];
      pairs[i] = {std::min(first, second), std::max(first, second)};
    }
  }

  const Bvh& tree_;
};

void Bvh::visit_pairs(const Prepare& prepare, const VisitPairs& visit) const {
  PairSearch(*this).run(prepare, visit);
}

}  // namespace transformesh
