/// The options of tm-select that cut a mesh at a plane.
#pragma once

#include <string>
#include <vector>

#include "frame/run.h"

namespace transformesh::tool {

struct CutChoices {
  std::vector<double> plane;  ///< a b c d; empty if nothing is cut
  std::string section;        ///< file of the curves in the plane
  bool cap = false;
};

/// The program keeps references to the choices.
void declare_cut(Program& program, CutChoices& choices);

/// Throws UsageError for options that need a plane, and for a plane of inverted conditions.
void check_cut(const CutChoices& choices, bool is_inverted);

/// Cuts the mesh if a plane is given, and writes the curves in it.
void cut_document(Document& document, const CutChoices& choices, Run& run);

}  // namespace transformesh::tool
