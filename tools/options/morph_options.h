/// The options of tm-morph, and their conversion to options of the library.
#pragma once

#include <string>

#include "frame/loop_options.h"
#include "frame/run.h"
#include "transformesh/morph.h"

namespace transformesh::tool {

/// Values of the options on the command line. Values that need no conversion are stored in
/// `options`. The others are converted by morphing_of().
struct MorphChoices {
  std::string target;
  bool sequence = false;
  MorphOptions options;
  std::string smooth = "0.1";
  bool print_pipeline = false;
  LoopChoices loop;
};

void declare_morph(Program& program, MorphChoices& choices);

/// Throws UsageError if source, target and frames are inconsistent.
void check_morph(const MorphChoices& choices, const Run& run);

/// Returns the options of morph(), with lengths resolved for the mesh of the run.
MorphOptions morphing_of(const MorphChoices& choices, Run& run);

/// Returns a shell script that makes the same meshes as tm-morph. The script is a loop that calls a
/// separate program for each step.
std::string pipeline_of(const MorphChoices& choices, const Run& run);

}  // namespace transformesh::tool
