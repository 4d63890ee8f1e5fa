#include "cleaning_report.h"
#include "frame/run.h"
#include "tm/clean/clean.h"
#include "tm/clean/clean_box.h"
#include "tm/clean/stitch/separate.h"
#include "tm/geometry/source_points.h"
#include "tm/support/counted.h"
#include "tm/support/error.h"

using namespace transformesh;

namespace {

constexpr const char* face_number = "tm:source-face";  // while cleaning

struct Options {
  CleanOptions clean;
  std::string method = "grow";
  long level = 1;
  bool source_faces = false;
  bool source_points = false;
  Length separate;
  std::vector<double> box;
  bool only = false;
};

// What the whole mesh is needed for has no meaning in a box.
void check_options(const Options& options) {
  if (options.box.empty()) {
    if (options.only) throw UsageError("--only: needs --box, whose faces it writes");
    return;
  }
  const char* const refused = options.method != "grow"      ? "--method static"
                              : options.clean.outermost     ? "--outermost"
                              : options.separate.value != 0 ? "--separate"
                                                            : nullptr;
  if (refused) throw UsageError(std::string(refused) + " is for whole meshes, without --box");
}

void number_faces(Mesh& mesh, const char* name) {
  Column& column = mesh.face_columns.get(name, Scalar::int32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) column.values[f] = static_cast<double>(f);
}

// And no longer the numbers of faces by which they are found.
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
             " in the place of another: on a border, or faces would cross");
  }
  return result;
}

CleanResult clean_in_box(const Mesh& mesh, const Options& options, tool::Run& run) {
  const std::vector<double>& b = options.box;
  CleanBoxOptions how{{{b[0], b[1], b[2]}, {b[3], b[4], b[5]}}, options.only};
  how.level = options.clean.level;
  how.refuse = options.clean.refuse;
  how.coordinate = options.clean.coordinate;
  CleanBoxResult result = clean_box(mesh, how, run.progress());
  if (result.is_whole)
    run.note("rounding makes faces cross in the box: the whole mesh was cleaned to mend that");
  run.report("box_faces", result.box_faces);
  run.report("whole_mesh", result.is_whole);
  return std::move(result.clean);
}

void clean_document(Document& document, Options options, tool::Run& run) {
  check_options(options);
  options.clean.method =
      options.method == "grow" ? ExteriorMethod::grow : ExteriorMethod::static_test;
  options.clean.level = static_cast<int>(options.level);
  options.clean.coordinate = document.style.coordinate;
  if (options.source_faces) number_faces(document.mesh, "source_face");
  Mesh source;
  if (options.source_points) {
    source = {document.mesh.positions, document.mesh.faces, {}, {}};
    number_faces(document.mesh, face_number);
  }
  CleanResult result = options.box.empty() ? clean(document.mesh, options.clean, run.progress())
                                           : clean_in_box(document.mesh, options, run);
  document.mesh = std::move(result.mesh);
  const SeparateResult separated =
      separate_copies(document.mesh, run.length(options.separate), options.clean.coordinate, run);
  if (options.clean.refuse && separated.separated_vertices > 0) {
    throw GoalError("vertices lie in one place, and --refuse forbids to move them apart");
  }
  if (options.source_points) {
    write_source_points(document.mesh, source);
    result.dropped_source_points = false;
  }

  tool::report_cleaning(result, separated, document.mesh, run);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-clean", "[OPTION]... [INPUT]",
                        "Removes self-intersections: the boundary of winding number >= 1"};
  program.cleans = true;
  program.joins_soups = true;
  program.choice("method", &options.method, {"grow", "static"},
                 "grow regions from seeds, or test every piece (slow reference)");
  program.integer("level", &options.level, 1, 1000000,
                  "keep the boundary of winding number >= LEVEL; 2 intersects two operands");
  program.flag("outermost", &options.clean.outermost,
               "drop components that bound cavities and what floats in them");
  program.length("separate", &options.separate,
                 "move vertices that lie in one place this far apart; 0 leaves them");
  program.numbers("box", &options.box, "X0,Y0,Z0,X1,Y1,Z1",
                  "clean the faces whose first vertex is in this box, and leave all others");
  program.flag("only", &options.only, "write the faces of the box alone");
  program.flag("refuse", &options.clean.refuse, "exit 4 rather than change anything");
  program.flag("source-face", &options.source_faces,
               "write the input face of each face as the face property source_face");
  program.flag("source", &options.source_points,
               "write where on the input each vertex comes from: source_face, source_u, source_v");
  return program.run(argc, argv,
                     [&](tool::Run& run) { clean_document(run.document(), options, run); });
}
