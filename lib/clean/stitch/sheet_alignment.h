/// Edges at which more than two sheets end, and the agreement of sheets at these edges (orient.h).
///
/// The sum of a sheet at an edge is the number of its forward faces minus the number of its
/// backward faces. The agreement of two sheets is minus the product of their sums, added over
/// common edges. It counts the pairs of faces with opposite directions minus the pairs with equal
/// directions.
///
/// Sheets with equal sums at the same edges have the same kind, for example n copies of a face, or
/// n faces at one edge. Links are stored per kind instead of per sheet. Therefore n sheets of few
/// kinds cost O(n log n). Deterministic.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <queue>
#include <utility>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

class SheetAlignment {
 public:
  explicit SheetAlignment(std::size_t sheets) : ends_(sheets) {}

  /// Adds an edge with the sum of each sheet that ends there.
  void add_edge(const std::map<Index, int>& sums);
  /// Finds the kinds. Call this once, after all edges are added.
  void find_kinds();

  /// Returns the group of a sheet: all sheets linked with it, in the order in which they are
  /// reached. Follows the strongest link first; ties are broken by the lowest sheet, then by the
  /// unreversed state. Sets for each sheet whether it is reversed, so that it agrees with the sheet
  /// before it. Returns an empty group if the sheet belongs to an earlier group.
  std::vector<Index> align(Index first, std::vector<char>& is_reversed);

  /// Initializes the sums along the edges of a group, which agreement() uses and reverse() updates.
  void sum_up(const std::vector<Index>& group, const std::vector<char>& is_reversed);
  /// Returns the agreement of a sheet with all other sheets.
  std::int64_t agreement(Index sheet, bool is_reversed) const;
  /// Updates the sums after a sheet is reversed. `was_reversed` is the state before.
  void reverse(Index sheet, bool was_reversed);

 private:
  using End = std::pair<Index, int>;  ///< an edge, and the nonzero sum of a sheet at this edge
  /// A link from an aligned sheet to all sheets of a kind that are not yet aligned.
  struct Step {
    std::int64_t strength = -1;
    Index sheet = no_index;  ///< the lowest sheet of the kind that is not yet aligned
    bool is_reversed = false;
    bool operator<(const Step& other) const {
      if (strength != other.strength) return strength < other.strength;
      return sheet != other.sheet ? sheet > other.sheet : is_reversed > other.is_reversed;
    }
  };
  struct Kind {
    std::vector<Index> sheets;
    std::size_t aligned = 0;  ///< number of aligned sheets; the lowest ones are aligned first
    Step best{};              ///< the strongest link to this kind
    /// True if links from an unreversed sheet [0] or a reversed sheet [1] exist.
    std::array<bool, 2> has_links{};
    const std::vector<End>* ends = nullptr;
  };

  void push(Index kind);
  void link(Index from, bool is_reversed);

  /// Ends of each sheet, sorted by edge.
  std::vector<std::vector<End>> ends_;
  std::vector<std::int64_t> sums_;  ///< sum of the sheets of the group at each edge
  /// Kinds of the sheets that end at each edge, with their sums.
  std::vector<std::vector<std::pair<Index, int>>> kinds_at_;
  std::vector<Index> kind_of_;  ///< kind of each sheet
  std::vector<Kind> kinds_;
  std::priority_queue<Step> steps_;
};

}  // namespace transformesh
