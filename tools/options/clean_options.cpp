#include "options/clean_options.h"

namespace transformesh::tool {
void declare_cleaning(Program& program, CleanChoices& choices) {
  program.options.named(
      "method", &choices.clean.method,
      {{"grow", ExteriorMethod::grow}, {"static", ExteriorMethod::static_test}},
      "grow regions from seeds, or test every piece of every face, which is slow");
  program.options.integer(
      "level", &choices.clean.winding_level, 1, 1000000,
      "keep the boundary of the points with winding number >= N; 2 intersects two bodies");
  program.options.flag("outermost", &choices.clean.outermost,
                       "drop components that bound cavities, and components inside cavities");
  program.options.length("separate", &choices.separate,
                         "move vertices with equal positions about this far apart; 0: off");
  program.options.box("box", &choices.clean.box, "X0,Y0,Z0,X1,Y1,Z1",
                      "clean only the faces whose first vertex is in this box");
  program.options.flag("only", &choices.clean.only, "with --box: write only the faces of the box");
  program.options.flag("merge-flat", &choices.clean.merge_flat,
                       "retriangulate flat regions in which faces were cut, with few triangles");
  program.options.flag("refuse", &choices.clean.refuse, "exit with 4 if the mesh would change");
  program.options.flag(
      "source-face", &choices.source_faces,
      "write the index of each face's input face as the face property source_face");
  program.options.flag("source", &choices.source_points,
                       "write the source point of each vertex and face on the input, as the "
                       "properties source_face, source_u and source_v");
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
