/// The name that a user most likely meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace transformesh {

/// The candidate with the fewest single-character edits (insertion, deletion, replacement,
/// exchange of neighbors) from `text`; a candidate that begins with `text` counts as one edit.
/// The first of equals wins; empty where there is no candidate.
std::string nearest_name(std::string_view text, const std::vector<std::string>& candidates);

/// Whether it is near enough to be meant: at most half the characters of `text` are edited.
bool is_near(std::string_view text, std::string_view name);

}  // namespace transformesh
