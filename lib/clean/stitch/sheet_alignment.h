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

  /// Adds an edge of more than two faces. `sums` has an entry for each sheet that ends at the edge:
  /// the number of its faces that traverse the edge forward minus those that traverse it backward.
  void add_edge(const std::map<Index, int>& sums);
  /// Groups sheets with equal sums at the same edges. Each such group is called a kind. Call this
  /// once, after all edges are added.
  void find_kinds();

  /// Returns the group of a sheet: all sheets that are connected with it by links, in the order in
  /// which they are reached. Follows the strongest link first. Of equally strong links, the link to
  /// the lowest sheet is followed, and then the link that does not reverse this sheet. Sets
  /// `is_reversed` for each sheet of the group, so that it agrees with the sheet from which it was
  /// reached. Returns an empty group if a previous call already returned the sheet.
  std::vector<Index> align(Index first, std::vector<char>& is_reversed);

  /// Computes a sum for each edge: the number of faces of the group that traverse the edge forward,
  /// minus the number that traverse it backward. agreement() uses these sums.
  void sum_up(const std::vector<Index>& group, const std::vector<char>& is_reversed);
  /// Returns the agreement of a sheet with the rest of its group, after sum_up(). It is the number
  /// of pairs of faces that traverse an edge in opposite directions, minus the pairs with equal
  /// directions.
  std::int64_t agreement(Index sheet, bool is_reversed) const;
  /// Updates the sums of sum_up() after a sheet is reversed. `was_reversed` is the state of the
  /// sheet before.
  void reverse(Index sheet, bool was_reversed);

 private:
  /// An edge, and the sum of a sheet there: its faces that traverse the edge forward minus those
  /// that traverse it backward; not 0.
  using End = std::pair<Index, int>;
  /// A link between sheets with common edges. It leads from a sheet whose orientation is final to
  /// sheets of one kind, whose orientation is not. A kind is a set of sheets with equal sums at the
  /// same edges.
  struct Step {
    std::int64_t strength = -1;
    Index sheet = no_index;  ///< first sheet of the kind to which the link leads
    bool is_reversed = false;
    bool operator<(const Step& other) const {
      if (strength != other.strength) return strength < other.strength;
      return sheet != other.sheet ? sheet > other.sheet : is_reversed > other.is_reversed;
    }
  };
  struct Kind {
    std::vector<Index> sheets;
    /// Number of sheets at the front of `sheets` that align() has returned.
    std::size_t aligned = 0;
    Step best{};  ///< strongest link that leads to sheets of this kind
    /// True if the links from a sheet of this kind to other kinds were followed. Entry 0 is for
    /// sheets that are not reversed, entry 1 for reversed sheets.
    std::array<bool, 2> has_links{};
    const std::vector<End>* ends = nullptr;
  };

  void push(Index kind);
  void link(Index from, bool is_reversed);

  /// For each sheet, the edges at which it ends with a nonzero sum (`End`), in ascending order.
  std::vector<std::vector<End>> ends_;
  /// For each edge, the sum over all sheets of the group of sum_up().
  std::vector<std::int64_t> sums_;
  /// For each edge, the kinds of the sheets that end there. A kind is a set of equivalent sheets;
  /// the second number is the sum of each of its sheets at the edge.
  std::vector<std::vector<std::pair<Index, int>>> kinds_at_;
  /// For each sheet, the index of its kind (set of equivalent sheets).
  std::vector<Index> kind_of_;
  std::vector<Kind> kinds_;
  std::priority_queue<Step> steps_;
};

}  // namespace transformesh
