/// The options of tm-select that cut a mesh at a plane.
#pragma once

#include <string>
#include <vector>

#include "frame/run.h"

namespace transformesh::tool {

struct CutChoices {
  std::vector<double> plane;  ///< coefficients a b c d of the plane; empty if nothing is cut
  std::string section;        ///< output file for the curves in the plane
  bool cap = false;
};

/// Declares the options. The program keeps references to the choices.
void declare_cut(Program& program, CutChoices& choices);

/// Throws UsageError for options that need a plane if no plane is given, and for a plane together
/// with --invert.
void check_cut(const CutChoices& choices, bool is_inverted);

/// Cuts the mesh and writes the curves in the plane, if a plane is given.
void cut_document(Document& document, const CutChoices& choices, Run& run);

}  // namespace transformesh::tool
