/// Values as reports show them, and what every report holds beside the program's own values.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "tm/evolution/stopwatch.h"

namespace transformesh::tool {

using Json = nlohmann::ordered_json;

/// true or false, shortest numbers, text as it is, the values of a list with separators.
std::string text_of(const Json& value, const std::string& separator = " ");

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
  Json seconds_ = Json::object();
};

/// What a run found and did, and how long it took.
struct Report {
  Json result = Json::object();
  Json input, output;  ///< counts of vertices and faces; null where there was none
  Phases phases;
};

/// The largest amount of memory that this process has held so far, in bytes.
long peak_memory_bytes();

}  // namespace transformesh::tool
