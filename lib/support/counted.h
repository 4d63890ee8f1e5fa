/// Counts with nouns in messages.
#pragma once

#include <cstddef>
#include <string>

namespace transformesh {

/// Returns text like "1 face", "2 faces"; "1 pass", "2 passes"; "1 vertex", "2 vertices".
inline std::string counted(std::size_t count, const std::string& noun) {
  const std::string number = std::to_string(count) + ' ';
  if (count == 1) return number + noun;
  if (noun.ends_with("vertex")) return number + noun.substr(0, noun.size() - 2) + "ices";
  return number + noun + (noun.ends_with('s') ? "es" : "s");
}

/// Returns text like "there is 1 face", "there are 2 faces".
inline std::string there_are(std::size_t count, const std::string& noun) {
  return (count == 1 ? "there is " : "there are ") + counted(count, noun);
}

}  // namespace transformesh
