/// The options of tm-clean.
#pragma once

#include <string>
#include <vector>

#include "frame/run.h"
#include "transformesh/clean.h"

namespace transformesh::tool {

/// Values of the options on the command line. Values that need no conversion are stored in `clean`.
/// The others are converted by clean_options().
struct CleanChoices {
  CleanOptions clean;
  bool source_faces = false, source_points = false;
  Length separate;
};

void declare_cleaning(Program& program, CleanChoices& choices);

/// Returns the options of clean(), with lengths resolved for the mesh of the run.
CleanOptions clean_options(const CleanChoices& choices, Run& run);

}  // namespace transformesh::tool
