/// Groups and agreements of random sheets, compared with the definitions over all pairs of sheets.
#include "clean/stitch/sheet_alignment.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <random>
#include <set>

using namespace transformesh;

namespace {

using Sums = std::map<Index, int>;  ///< sum of each sheet at one edge

/// There are few different sums, so that many sheets are alike.
std::vector<Sums> random_edges(std::mt19937& random, Index sheets) {
  std::vector<Sums> edges(1 + random() % 5);
  for (Index sheet = 0; sheet < sheets; ++sheet) {
    const std::size_t pattern = random() % 4;
    for (std::size_t e = 0; e < edges.size(); ++e)
      if ((e + pattern) % 3 != 0) edges[e][sheet] = static_cast<int>((e * pattern) % 4) - 1;
  }
  return edges;
}

class AllPairs {
 public:
  AllPairs(const std::vector<Sums>& edges, Index sheets) : agreement_(sheets) {
    for (const Sums& sums : edges)
      for (const auto& [a, sum] : sums)
        for (const auto& [b, other] : sums)
          if (a != b && sum != 0 && other != 0) agreement_[a][b] -= sum * other;
  }

  /// Collects the group of a sheet. Repeatedly adds the sheet with the strongest agreement, of
  /// either sign, with a sheet of the group.
  std::vector<Index> align(Index first, std::vector<char>& is_reversed) const {
    std::vector<Index> group{first};
    std::set<Index> members{first};
    is_reversed[first] = 0;
    for (;;) {
      // The least tuple has the strongest agreement; ties are broken by the lowest sheet.
      std::tuple<int, Index, char> best{0, no_index, 0};
      for (const Index a : group)
        for (const auto& [b, sum] : agreement_[a])
          if (!members.contains(b)) {
            const char reversed = (is_reversed[a] != 0) != (sum < 0) ? 1 : 0;
            const std::tuple<int, Index, char> step{-std::abs(sum), b, reversed};
            if (std::get<1>(best) == no_index || step < best) best = step;
          }
      const auto [strength, sheet, reversed] = best;
      if (sheet == no_index) return group;
      group.push_back(sheet);
      members.insert(sheet);
      is_reversed[sheet] = reversed;
    }
  }

  int agreement(Index sheet, const std::vector<char>& is_reversed) const {
    int sum = 0;
    for (const auto& [other, agreement] : agreement_[sheet])
      sum += is_reversed[sheet] == is_reversed[other] ? agreement : -agreement;
    return sum;
  }

 private:
  std::vector<std::map<Index, int>> agreement_;
};

}  // namespace

TEST_CASE("sheets are aligned as if every pair of them was linked") {
  std::mt19937 random(1);
  for (int trial = 0; trial < 300; ++trial) {
    CAPTURE(trial);
    const Index sheets = 2 + random() % 30;
    const std::vector<Sums> edges = random_edges(random, sheets);
    SheetAlignment links(sheets);
    for (const Sums& sums : edges) links.add_edge(sums);
    links.find_kinds();
    const AllPairs expected(edges, sheets);

    std::set<Index> done;
    std::vector<char> is_reversed(sheets, 0), expected_reversed(sheets, 0);
    for (Index first = 0; first < sheets; ++first) {
      const std::vector<Index> group = links.align(first, is_reversed);
      CHECK(group.empty() == done.contains(first));
      if (group.empty()) continue;
      CHECK(group == expected.align(first, expected_reversed));
      done.insert(group.begin(), group.end());
      links.sum_up(group, is_reversed);
      for (const Index sheet : group) {
        CHECK(links.agreement(sheet, is_reversed[sheet] != 0) ==
              expected.agreement(sheet, is_reversed));
        links.reverse(sheet, is_reversed[sheet] != 0);
        is_reversed[sheet] ^= 1;
        expected_reversed[sheet] ^= 1;
      }
    }
    CHECK(is_reversed == expected_reversed);
  }
}
