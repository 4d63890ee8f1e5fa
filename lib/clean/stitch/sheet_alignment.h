/// Decides which sheets (connected faces, orient.h) have to be reversed so that they agree at the
/// edges of more than two faces at which they end.
///
/// The sum of a sheet at an edge is the number of its faces that traverse the edge forward minus
/// the number that traverse it backward. Two sheets are linked if they end at a common edge. Their
/// agreement, the strength of the link, is minus the product of their sums, added over all common
/// edges. The agreement is the number of pairs of faces with opposite directions minus the number
/// of pairs with equal directions.
///
/// Sheets with equal sums at the same edges form a kind, for example n copies of a face, or n faces
/// at one edge. Links are stored between kinds instead of sheets. Therefore n sheets of few kinds
/// cost O(n log n). Deterministic.
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

  /// Adds an edge of more than two faces. `sums` maps each sheet that ends there to its sum at the
  /// edge.
  void add_edge(const std::map<Index, int>& sums);
  /// Groups sheets with equal sums at the same edges to kinds. Call this once, after all edges are
  /// added.
  void find_kinds();

  /// Returns the group of a sheet: all sheets that are connected with it by links, in the order in
  /// which they are reached. Follows the strongest link first. Of equally strong links, the link to
  /// the lowest sheet is followed, and then the link that does not reverse this sheet. Sets
  /// `is_reversed` for each sheet of the group, so that it agrees with the sheet from which it was
  /// reached. Returns an empty group if a previous call already returned the sheet.
  std::vector<Index> align(Index first, std::vector<char>& is_reversed);

  /// Computes for each edge the sum of all sheets of a group. agreement() uses these sums, and
  /// reverse() updates them.
  void sum_up(const std::vector<Index>& group, const std::vector<char>& is_reversed);
  /// Returns the agreement of a sheet with all other sheets of its group, after sum_up().
  std::int64_t agreement(Index sheet, bool is_reversed) const;
  /// Updates the sums after a sheet is reversed. `was_reversed` is the state before.
  void reverse(Index sheet, bool was_reversed);

 private:
  using End = std::pair<Index, int>;  ///< an edge, and the nonzero sum of a sheet at this edge
  /// A link from a sheet that has its final state (reversed or not) to the sheets of one kind
  /// without final state. A kind is a set of sheets with equal sums at the same edges.
  struct Step {
    std::int64_t strength = -1;
    Index sheet = no_index;  ///< the lowest sheet of the kind without final state
    bool is_reversed = false;
    bool operator<(const Step& other) const {
      if (strength != other.strength) return strength < other.strength;
      return sheet != other.sheet ? sheet > other.sheet : is_reversed > other.is_reversed;
    }
  };
  struct Kind {
    std::vector<Index> sheets;
    /// Number of sheets that align() returned so far; the lowest come first.
    std::size_t aligned = 0;
    Step best{};  ///< the strongest link to this kind
    /// Entry 0 (1) is true if the links from an unreversed (reversed) sheet of this kind to other
    /// kinds were followed.
    std::array<bool, 2> has_links{};
    const std::vector<End>* ends = nullptr;
  };

  void push(Index kind);
  void link(Index from, bool is_reversed);

  /// The edges at which each sheet ends with a nonzero sum, in ascending order.
  std::vector<std::vector<End>> ends_;
  std::vector<std::int64_t> sums_;  ///< for each edge the sum of all sheets of the group
  /// For each edge the kinds of the sheets that end there, with the sum of each sheet of the kind.
  std::vector<std::vector<std::pair<Index, int>>> kinds_at_;
  std::vector<Index> kind_of_;  ///< kind of each sheet
  std::vector<Kind> kinds_;
  std::priority_queue<Step> steps_;
};

}  // namespace transformesh
