#include "clean/stitch/separate.h"
#include "frame/run.h"
#include "geometry/source_points.h"
#include "mesh/surface_columns.h"
#include "options/clean_options.h"
#include "options/cleaning_report.h"
#include "support/counted.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

constexpr const char* face_number = "tm:source-face";  // while cleaning

void number_faces(Mesh& mesh, const char* name) {
  Column& column = mesh.face_columns.get(name, Scalar::int32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) column.values[f] = static_cast<double>(f);
}

// Removes the temporary column of face numbers, too.
void write_source_points(Mesh& mesh, const Mesh& source) {
  const Column& numbers = *mesh.face_columns.find(face_number);
  transformesh::write_source_points(mesh, source_points_of_pieces(source, mesh, numbers.values));
  mesh.face_columns.erase(face_number);
}

SeparateResult separate_copies(Mesh& mesh, double distance, Scalar coordinate, tool::Run& run) {
  if (distance == 0) return {};
  const SeparateResult result = separate(mesh, {distance, coordinate}, run.progress());
  if (result.refused_vertices > 0) {
    run.note(counted(result.refused_vertices, "vertex") +
             (result.refused_vertices == 1 ? " stays" : " stay") +
             " in the place of another: on a border, or faces would intersect");
  }
  return result;
}

CleanResult clean_in_box(const Mesh& mesh, const CleanBoxOptions& options, tool::Run& run) {
  CleanBoxResult result = clean_box(mesh, options, run.progress());
  if (result.is_whole)
    run.note("rounding makes faces intersect in the box: the whole mesh was cleaned to mend that");
  run.report("box_faces", result.box_faces);
  run.report("whole_mesh", result.is_whole);
  return std::move(result.clean);
}

void clean_document(Document& document, const tool::CleanChoices& choices, tool::Run& run) {
  const CleanOptions options = tool::clean_options(choices, document);
  const bool replaced_sources = choices.source_faces && drop_source_points(document.mesh);
  if (choices.source_faces) number_faces(document.mesh, "source_face");
  Mesh source;
  if (choices.source_points) {
    source = {document.mesh.positions, document.mesh.faces, {}, {}};
    number_faces(document.mesh, face_number);
  }
  CleanResult result =
      choices.box.empty()
          ? clean(document.mesh, options, run.progress())
          : clean_in_box(document.mesh, tool::clean_box_options(choices, document), run);
  document.mesh = std::move(result.mesh);
  const SeparateResult separated =
      separate_copies(document.mesh, run.length(choices.separate), options.coordinate, run);
  if (options.refuse && separated.separated_vertices > 0) {
    throw GoalError("vertices lie in one place, and --refuse forbids to move them apart");
  }
  result.dropped_source_points |= replaced_sources;
  if (choices.source_points) {
    write_source_points(document.mesh, source);
    result.dropped_source_points = false;
  }

  tool::report_cleaning(result, separated, document.mesh, run);
}

}  // namespace

int main(int argc, char** argv) {
  tool::CleanChoices choices;
  tool::Program program{"tm-clean", "[OPTION]... [INPUT]",
                        "Removes self-intersections: the boundary of winding number >= 1"};
  program.cleans = true;
  program.soups = tool::Soups::own;
  tool::declare_cleaning(program, choices);
  return program.run(argc, argv,
                     [&](tool::Run& run) { clean_document(run.document(), choices, run); });
}
