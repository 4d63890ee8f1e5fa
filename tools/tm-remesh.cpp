/// tm-remesh: edges between two lengths, six at a vertex, round triangles (paper 5.1.2).
#include "frame/column_notes.h"
#include "frame/run.h"
#include "remesh_options.h"
#include "tm/remesh/remesh.h"

namespace {

using namespace transformesh;

void decimate_document(Document& document, const DecimateOptions& options, tool::Run& run) {
  const std::size_t before = document.mesh.faces.size();
  if (before < options.faces)
    run.note("the mesh has " + std::to_string(before) + " faces, which are not more than " +
             std::to_string(options.faces) + ": it stays as it is; --max-edge makes more");
  const DecimateResult result = decimate(document.mesh, options, run.progress());
  run.report("collapses", result.collapses);
  run.report("faces", result.faces);
  tool::note_new_normals(result.columns.new_normals, run);
  tool::note_dropped_lists(result.columns.dropped, run);
}

void remesh_document(Document& document, tool::RemeshChoices& choices, tool::Run& run) {
  const RemeshOptions options = tool::remesh_options(choices, document, run);
  const RemeshResult result = remesh(document.mesh, options, run.progress());
  run.report("splits", result.splits);
  run.report("collapses", result.collapses);
  run.report("flips", result.flips);
  run.report("refused", result.refused);
  run.report("components_removed", result.components_removed);
  run.report("degenerate_faces", result.degenerate_faces);
  tool::note_new_normals(result.columns.new_normals, run);
  tool::note_dropped_lists(result.columns.dropped, run);
}

}  // namespace

int main(int argc, char** argv) {
  tool::RemeshChoices choices;
  tool::Program program{"tm-remesh", "[OPTION]... [INPUT]",
                        "Keeps edges between two lengths and triangles round"};
  tool::declare_remeshing(program, choices);
  program.epilog = "After a step of an evolution: tm-clean < moved.ply | tm-remesh > next.ply";
  return program.run(argc, argv, [&](tool::Run& run) {
    if (choices.faces)
      decimate_document(run.document(), decimate_options(choices, run.document(), program), run);
    else
      remesh_document(run.document(), choices, run);
  });
}
