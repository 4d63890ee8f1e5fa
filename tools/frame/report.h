/// Values of options and reports as text and JSON, and times of the phases of a run.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "entries/entries.h"
#include "evolution/loop/stopwatch.h"

namespace transformesh::tool {

using Json = nlohmann::ordered_json;

/// Returns a value as text: `true` or `false`, numbers with the fewest digits that identify them,
/// and the numbers of a list with `separator` between them.
std::string text_of(const Value& value, const std::string& separator = " ");

/// Returns a value as JSON. Lengths become text such as "0.7x", with their unit.
Json json_of(const Value& value);
Json object_of(const Entries& entries);

/// Returns indented JSON with a line end. Bytes that are not UTF-8 are replaced.
std::string json_text(const Json& json);

/// Measures the seconds of each phase of a run. Phases are listed by name in order of first
/// appearance.
class Phases {
 public:
  /// Ends the current phase and begins another. Times of phases with equal names are added. An
  /// empty name begins no phase.
  void begin(std::string_view name);
  /// Returns the seconds of all phases, and their `total`.
  Json seconds() const;

 private:
  Stopwatch total_, phase_;
  std::string current_;
  std::vector<std::pair<std::string, double>> seconds_;
};

/// Returns the peak memory of this process so far, in bytes.
long peak_memory_bytes();

}  // namespace transformesh::tool
