/// The options that programs share: one spelling everywhere.
#pragma once

#include <string>

namespace transformesh::tool {

struct Command;

struct CommonOptions {
  std::string output = "-";
  std::string format;
  bool as_float = false;
  bool as_double = false;
  std::string reference_edge;
  bool no_provenance = false;
  bool json = false;
  std::string report;
  long threads = 0;
  bool progress = false;
  bool no_progress = false;
  bool quiet = false;
  bool verbose = false;
  bool help = false;
  bool version = false;
};

/// Adds those that apply to what the command reads and writes.
void add_common_options(Command& command);

/// Throws UsageError where two of the options given contradict each other.
void check_common_options(const CommonOptions& values);

}  // namespace transformesh::tool
