/// The options that all programs of a kind share: one spelling everywhere.
#pragma once

#include <string>

#include "option_table.h"

namespace transformesh::tool {

/// What a program reads and writes, which decides the common options that it has.
struct Kind {
  bool reads_mesh = true;
  bool many_inputs = false;
  bool writes_mesh = true;
  bool makes_mesh = false;     ///< what it reads is no mesh whose edges could be a reference
  bool prints_report = false;  ///< on stdout
  bool is_predicate = false;   ///< may answer no
};

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

/// Adds those that apply to a program of this kind.
void add_common_options(OptionTable& table, const Kind& kind, CommonOptions& values);

/// Throws UsageError where two of the options given contradict each other.
void check_common_options(const CommonOptions& values);

}  // namespace transformesh::tool
