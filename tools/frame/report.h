/// Values of options and reports, and how long the phases of a run take.
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

/// true or false, shortest numbers, text as it is, the values of a list with separators.
std::string text_of(const Value& value, const std::string& separator = " ");

/// The same for JSON, where a length is text.
Json json_of(const Value& value);
Json object_of(const Entries& entries);

/// Indented, with a line end; bytes that are not UTF-8 are replaced.
std::string json_text(const Json& json);

/// How long each phase of a run took, in seconds by name, in order of first appearance.
class Phases {
 public:
  /// Ends the phase that runs and begins this one; time of equal names adds up. An empty name only
  /// ends.
  void begin(std::string_view name);
  /// With the `total`.
  Json seconds() const;

 private:
  Stopwatch total_, phase_;
  std::string current_;
  std::vector<std::pair<std::string, double>> seconds_;
};

/// The largest amount of memory that this process has held so far, in bytes.
long peak_memory_bytes();

}  // namespace transformesh::tool
