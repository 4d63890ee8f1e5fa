/// Suggests a name in place of a misspelled name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace transformesh {

/// Returns the candidate with the fewest single-character edits from `text` (insertion, deletion,
/// replacement, exchange of neighbors). A candidate that starts with `text` counts as one edit. The
/// first of equally near candidates is returned; the result is empty if there is no candidate.
std::string nearest_name(std::string_view text, const std::vector<std::string>& candidates);

/// True if `name` is a plausible correction of `text`: `name` begins with `text`, or needs fewer
/// edits than half of the characters of `text`.
bool is_near(std::string_view text, std::string_view name);

}  // namespace transformesh
