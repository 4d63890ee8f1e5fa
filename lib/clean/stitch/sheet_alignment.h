/// The edges at which more than two sheets end, and how the sheets agree there (orient.h).
///
/// The sum of a sheet at an edge is how many more of its faces are directed forward than backward.
/// Two sheets agree by the sum, over their common edges, of the product of their sums, negated: the
/// pairs of their faces that have opposite directions less the pairs that have the same direction.
///
/// Sheets with the same sums at the same edges are one kind: n copies of a face, or n faces at one
/// edge. Kinds are linked, not sheets, so that n sheets of a few kinds cost O(n log n).
/// Deterministic.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <queue>
#include <utility>
#include <vector>

#include "mesh/mesh.h"

namespace transformesh {

class SheetAlignment {
 public:
  explicit SheetAlignment(std::size_t sheets) : ends_(sheets) {}

  /// Adds an edge with the sum of each sheet that ends there.
  void add_edge(const std::map<Index, int>& sums);
  /// Finds the kinds. Call it once, after all edges are added.
  void find_kinds();

  /// Returns the group of a sheet: all sheets linked with it, in the order in which they are
  /// reached. Along the strongest links first (ties: the lowest sheet, unreversed), sets whether
  /// each sheet is reversed, so that it agrees with the sheet before it. Empty if an earlier group
  /// holds the sheet.
  std::vector<Index> align(Index first, std::vector<char>& is_reversed);

  /// Sums up the edges of a group. agreement() counts with these sums, and reverse() keeps them up.
  void sum_up(const std::vector<Index>& group, const std::vector<char>& is_reversed);
  /// Returns how far the sheet agrees with all others.
  std::int64_t agreement(Index sheet, bool is_reversed) const;
  /// Takes note that the sheet, which was not reversed or was, now is the other way.
  void reverse(Index sheet, bool was_reversed);

 private:
  using End = std::pair<Index, int>;  ///< an edge, and the sum there, which is not 0
  /// A link from a sheet that is aligned to all sheets of a kind that are not.
  struct Step {
    std::int64_t strength = -1;
    Index sheet = no_index;  ///< the lowest one
    bool is_reversed = false;
    bool operator<(const Step& other) const {
      if (strength != other.strength) return strength < other.strength;
      return sheet != other.sheet ? sheet > other.sheet : is_reversed > other.is_reversed;
    }
  };
  struct Kind {
    std::vector<Index> sheets;
    std::size_t aligned = 0;          ///< how many of the sheets are, the lowest first
    Step best{};                      ///< the strongest link that reaches it
    std::array<bool, 2> has_links{};  ///< of a sheet as it is, and of a reversed one
    const std::vector<End>* ends = nullptr;
  };

  void push(Index kind);
  void link(Index from, bool is_reversed);

  std::vector<std::vector<End>> ends_;                        ///< per sheet, ascending
  std::vector<std::int64_t> sums_;                            ///< per edge
  std::vector<std::vector<std::pair<Index, int>>> kinds_at_;  ///< per edge: kind and sum
  std::vector<Index> kind_of_;                                ///< per sheet
  std::vector<Kind> kinds_;
  std::priority_queue<Step> steps_;
};

}  // namespace transformesh
