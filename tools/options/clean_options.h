/// The options of tm-clean.
#pragma once

#include <string>
#include <vector>

#include "frame/run.h"
#include "transformesh/clean.h"

namespace transformesh::tool {

/// Options as they are written; the rest are in `clean`.
struct CleanChoices {
  CleanOptions clean;
  std::string method = "grow";
  long winding_level = 1;
  bool source_faces = false, source_points = false;
  Length separate;
  std::vector<double> box;
};

void declare_cleaning(Program& program, CleanChoices& choices);

/// Returns the options for the mesh that was read.
CleanOptions clean_options(const CleanChoices& choices, Run& run);

}  // namespace transformesh::tool
