#include "options/clean_options.h"

#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

// What the whole mesh is needed for has no meaning in a box.
void check_choices(const CleanChoices& choices) {
  if (choices.box.empty()) {
    if (choices.only) throw UsageError("--only: needs --box, whose faces it writes");
    return;
  }
  const char* const refused = choices.method != "grow"      ? "--method static"
                              : choices.clean.outermost     ? "--outermost"
                              : choices.separate.value != 0 ? "--separate"
                                                            : nullptr;
  if (refused) throw UsageError(std::string(refused) + " is for whole meshes, without --box");
}

}  // namespace

void declare_cleaning(Program& program, CleanChoices& choices) {
  program.choice("method", &choices.method, {"grow", "static"},
                 "grow regions from seeds, or test every piece (slow reference)");
  program.integer("level", &choices.winding_level, 1, 1000000,
                  "keep the boundary of winding number >= LEVEL; 2 intersects two operands");
  program.flag("outermost", &choices.clean.outermost,
               "drop components that bound cavities and what floats in them");
  program.length("separate", &choices.separate,
                 "move vertices that lie in one place this far apart; 0 leaves them");
  program.numbers("box", &choices.box, "X0,Y0,Z0,X1,Y1,Z1",
                  "clean the faces whose first vertex is in this box, and leave all others");
  program.flag("only", &choices.only, "write the faces of the box alone");
  program.flag("refuse", &choices.clean.refuse, "exit 4 rather than change anything");
  program.flag("source-face", &choices.source_faces,
               "write the input face of each face as the face property source_face");
  program.flag(
      "source", &choices.source_points,
      "write where on the input each vertex and face comes from: source_face, source_u, source_v");
}

CleanOptions clean_options(const CleanChoices& choices, const Document& document) {
  check_choices(choices);
  CleanOptions options = choices.clean;
  options.method = choices.method == "grow" ? ExteriorMethod::grow : ExteriorMethod::static_test;
  options.winding_level = static_cast<int>(choices.winding_level);
  options.coordinate = document.style.coordinate;
  return options;
}

CleanBoxOptions clean_box_options(const CleanChoices& choices, const Document& document) {
  const CleanOptions whole = clean_options(choices, document);
  const std::vector<double>& b = choices.box;
  CleanBoxOptions options{{{b[0], b[1], b[2]}, {b[3], b[4], b[5]}}, choices.only};
  options.winding_level = whole.winding_level;
  options.refuse = whole.refuse;
  options.coordinate = whole.coordinate;
  return options;
}

}  // namespace transformesh::tool
