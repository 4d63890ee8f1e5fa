/// The options of tm-morph, and what they mean to the library.
#pragma once

#include <string>

#include "frame/loop_options.h"
#include "frame/run.h"
#include "transformesh/morph.h"

namespace transformesh::tool {

/// Options as they are written; the rest are in `options`.
struct MorphChoices {
  std::string target;
  bool sequence = false;
  MorphOptions options;
  std::string distance = "auto";
  std::string smooth = "0.1";
  std::string features = "auto";
  bool print_pipeline = false;
  LoopChoices loop;
};

void declare_morph(Program& program, MorphChoices& choices);

/// Throws UsageError where source, target and frames do not go together.
void check_morph(const MorphChoices& choices, const Run& run);

/// With lengths that refer to the mesh of the run.
MorphOptions morphing_of(const MorphChoices& choices, Run& run);

/// The shell loop over the filters that makes the same meshes.
std::string pipeline_of(const MorphChoices& choices, const Run& run);

}  // namespace transformesh::tool
