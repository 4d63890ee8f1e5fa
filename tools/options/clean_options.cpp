#include "options/clean_options.h"

namespace transformesh::tool {
void declare_cleaning(Program& program, CleanChoices& choices) {
  program.options.named("method", &choices.clean.method,
                        {{"grow", ExteriorMethod::grow}, {"static", ExteriorMethod::static_test}},
                        "grow regions from seeds, or test every piece (slow reference)");
  program.options.integer("level", &choices.clean.winding_level, 1, 1000000,
                          "keep the boundary of winding number >= N; 2 intersects two operands");
  program.options.flag("outermost", &choices.clean.outermost,
                       "drop components that bound cavities and what floats in them");
  program.options.length("separate", &choices.separate,
                         "move vertices that lie in one place this far apart; 0 leaves them");
  program.options.box("box", &choices.clean.box, "X0,Y0,Z0,X1,Y1,Z1",
                      "clean the faces whose first vertex is in this box, and leave all others");
  program.options.flag("only", &choices.clean.only, "write the faces of the box alone");
  program.options.flag("merge-flat", &choices.clean.merge_flat,
                       "cover flat regions with few triangles where faces were cut");
  program.options.flag("refuse", &choices.clean.refuse, "exit 4 rather than change anything");
  program.options.flag("source-face", &choices.source_faces,
                       "write the input face of each face as the face property source_face");
  program.options.flag(
      "source", &choices.source_points,
      "write where on the input each vertex and face comes from: source_face, source_u, source_v");
}

CleanOptions clean_options(const CleanChoices& choices, Run& run) {
  CleanOptions options = choices.clean;
  options.separate = run.length(choices.separate);
  options.coordinate = run.document().style.coordinate;
  options.sources = choices.source_points  ? CleanSources::points
                    : choices.source_faces ? CleanSources::faces
                                           : CleanSources::none;
  return options;
}

}  // namespace transformesh::tool
