/// tm-remesh: brings edge lengths into an interval and valences close to six, and improves the
/// shape of triangles (section 5.1.2 of the TransforMesh paper).
#include "frame/column_notes.h"
#include "frame/run.h"
#include "geometry/source_points.h"
#include "io/comments.h"
#include "options/remesh_options.h"
#include "options/remesh_report.h"
#include "support/number.h"
#include "transformesh/measure.h"
#include "transformesh/remesh.h"

namespace {

using namespace transformesh;

// A note is printed if the reference edge and the current mean edge length differ by more than this
// factor.
constexpr double most_apart = 2;

StaleColumns decimate_document(Document& document, tool::RemeshChoices& choices, tool::Run& run) {
  const DecimateOptions options = tool::decimate_options(choices, document, run);
  const std::size_t before = document.mesh.faces.size();
  if (before < options.faces)
    run.note("the mesh has " + std::to_string(before) + " faces, fewer than the " +
             std::to_string(options.faces) +
             " wanted: the mesh stays as it is; make more faces with --max-edge");
  const DecimateResult result = decimate(document.mesh, options, run.progress());
  run.report(entries_of(result));
  tool::note_decimation(result, options, run);
  choices.keep_out.note_near(result.near_keep_out, run);
  return result.columns;
}

StaleColumns align_document(Document& document, tool::RemeshChoices& choices, tool::Run& run) {
  const AlignOptions options = tool::align_options(choices, document, run);
  const AlignResult result =
      align_features(document.mesh, run.in().read(choices.align).mesh, options, run.progress());
  run.report(entries_of(result));
  return result.columns;
}

bool refers_to_edge(const std::optional<Length>& length) {
  return length && length->unit == Length::Unit::reference_edge;
}

// Prints a note if the reference edge differs much from the mean edge, because the file may state
// the reference edge of an earlier mesh.
void note_reference_edge(const tool::RemeshChoices& choices, const Document& document,
                         tool::Run& run) {
  const bool is_used = refers_to_edge(choices.min_edge) || refers_to_edge(choices.max_edge) ||
                       refers_to_edge(choices.adaptive);
  const bool is_chosen = !run.program().common.reference_edge.empty();
  if (!is_used || is_chosen || !choices.remesh.size_column.empty()) return;
  if (!reference_edge_of(document.style.comments)) return;
  const double mean = edge_lengths(document.mesh).mean;
  const double reference = run.in().reference_edge();
  if (reference <= most_apart * mean && mean <= most_apart * reference) return;
  run.note("edges become " + significant(reference, 3) +
           " long, as the comment tm:reference-edge " + "says, but their mean length is " +
           significant(mean, 3) + " now; measure it again with --reference-edge auto");
}

StaleColumns remesh_document(Document& document, tool::RemeshChoices& choices, tool::Run& run) {
  const RemeshOptions options = tool::remesh_options(choices, document, run);
  note_reference_edge(choices, document, run);
  const RemeshResult result = remesh(document.mesh, options, run.progress());
  run.report(entries_of(result));
  choices.keep_out.note_near(result.near_keep_out, run);
  tool::note_dropped(result.components_removed, options, run);
  tool::note_slivers(result, run);
  return result.columns;
}

void change(Document& document, tool::RemeshChoices& choices, tool::Run& run) {
  const auto& step = choices.faces || choices.error ? decimate_document
                     : choices.align.empty()        ? remesh_document
                                                    : align_document;
  const StaleColumns columns = change_with_source_points(
      choices.source_points, document.mesh, [&](Mesh&) { return step(document, choices, run); });
  tool::note_new_normals(columns.new_normals, run);
  tool::note_dropped_lists(columns.dropped, run);
  if (!choices.source_points)
    tool::note_dropped_sources(columns.dropped_source_points, tool::source_of_step, run);
}

}  // namespace

int main(int argc, char** argv) {
  tool::RemeshChoices choices;
  tool::Program program{"tm-remesh", "[OPTION]... [INPUT]",
                        "Remeshes with edges between two lengths and well-shaped triangles"};
  program.input.soups = tool::Soups::joined;
  tool::declare_remeshing(program, choices);
  program.example = "tm-remesh --edge 2% rough.ply > fine.ply";
  return program.run(argc, argv, [&](tool::Run& run) { change(run.document(), choices, run); });
}
