#include "support/suggestion.h"

#include <algorithm>
#include <limits>

namespace transformesh {
namespace {

// Returns the optimal string alignment distance: the number of single-character edits and exchanges
// of adjacent characters. Only three rows of the dynamic-programming table are stored.
std::size_t edits(std::string_view from, std::string_view to) {
  std::vector<std::size_t> before_last;
  std::vector<std::size_t> last(to.size() + 1);
  for (std::size_t j = 0; j <= to.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= from.size(); ++i) {
    std::vector<std::size_t> row(to.size() + 1, i);
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replacement = last[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replacement});
      const bool exchanged = i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1];
      if (exchanged) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = std::move(last);
    last = std::move(row);
  }
  return last.back();
}

}  // namespace

std::string nearest_name(std::string_view text, const std::vector<std::string>& candidates) {
  std::string nearest;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (const std::string& candidate : candidates) {
    const bool is_prefix = !text.empty() && candidate.starts_with(text);
    const std::size_t count = is_prefix ? 1 : edits(text, candidate);
    if (count >= fewest) continue;
    fewest = count;
    nearest = candidate;
  }
  return nearest;
}

bool is_near(std::string_view text, std::string_view name) {
  return (!text.empty() && name.starts_with(text)) || 2 * edits(text, name) < text.size();
}

}  // namespace transformesh
