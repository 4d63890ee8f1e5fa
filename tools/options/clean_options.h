/// The options of tm-clean.
#pragma once

#include <string>
#include <vector>

#include "frame/run.h"
#include "transformesh/clean_box.h"

namespace transformesh::tool {

/// Options as they are written; the rest are in `clean`.
struct CleanChoices {
  CleanOptions clean;
  std::string method = "grow";
  long winding_level = 1;
  bool source_faces = false, source_points = false;  ///< to be written
  Length separate;
  std::vector<double> box;
  bool only = false;
};

void declare_cleaning(Program& program, CleanChoices& choices);

/// For the document. Throws UsageError where options do not go together.
CleanOptions clean_options(const CleanChoices& choices, const Document& document);
/// The same in a box.
CleanBoxOptions clean_box_options(const CleanChoices& choices, const Document& document);

}  // namespace transformesh::tool
