#include "frame/column_notes.h"
#include "frame/run.h"
#include "transformesh/stitch.h"

using namespace transformesh;

namespace {

void stitch_document(Document& document, StitchOptions options, const Length& tolerance,
                     tool::Run& run) {
  options.tolerance = run.length(tolerance);
  const StitchResult result = stitch(document.mesh, options);
  if (result.misoriented_edges > 0) {
    run.note(result.misorientation +
             (result.can_be_oriented
                  ? ": they stay apart; orient them with --orient"
                  : ", however faces are reversed: they stay apart, with borders there; close "
                    "these with tm-fill --allow-crossings"));
  }
  tool::note_new_normals(result.new_normals, run);
  run.report(entries_of(result));
}

}  // namespace

int main(int argc, char** argv) {
  StitchOptions options;
  Length tolerance;
  tool::Program program{"tm-stitch", "[OPTION]... [INPUT]",
                        "Joins a soup of triangles into a manifold mesh"};
  program.input.soups = tool::Soups::own;
  program.options.length("tolerance", &tolerance,
                         "join vertices within this distance; 0: join equal positions only");
  program.options.flag("orient", &options.orient,
                       "reverse faces so that neighbors agree; closed components that change are "
                       "then oriented outwards");
  program.options.flag("drop-copies", &options.drop_copies,
                       "keep one of coincident faces with the same orientation");
  program.options.flag("one-side", &options.one_side,
                       "keep one side of a double-sided model: drop the reverses of faces, reverse "
                       "faces so that neighbors agree, and orient closed components outwards");
  program.options.flag(
      "outwards", &options.outwards,
      "reverse closed components that are inside out, together with all components inside them");
  program.options.flag("flip", &options.flip, "reverse all faces");
  program.example = "tm-stitch model.stl > joined.ply";
  return program.run(argc, argv, [&](tool::Run& run) {
    stitch_document(run.document(), options, tolerance, run);
  });
}
