/// tm-compare: measures the distances between a mesh and a reference.
#include "clean/open/join_soup.h"
#include "frame/run.h"
#include "io/document/unit.h"
#include "io/formats/file_format.h"
#include "support/error_prefix.h"
#include "transformesh/compare.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

namespace {

using namespace transformesh;

struct Options {
  std::string reference;
  std::string per_vertex;
  bool is_signed = false;
  Length distance{0.01, Length::Unit::diagonal};
  std::optional<Length> within;
  CompareOptions compare;
};

// Writes the mesh with the property `distance`: the distance of each vertex from the reference.
void write_distances(const Mesh& reference, const Options& options, tool::Run& run) {
  Document& document = run.document();
  const auto& measure = options.is_signed ? signed_vertex_distances : vertex_distances;
  std::vector<double> distances = measure(document.mesh, reference, run.progress());
  document.mesh.vertex_columns.get("distance", document.style.coordinate, distances.size()).values =
      std::move(distances);
  run.out().write_mesh_file(options.per_vertex, std::move(document));
}

/// Returns the mesh of --reference, or the second input.
Mesh read_reference(const Options& options, tool::Run& run) {
  std::vector<Document>& documents = run.in().documents();
  const std::size_t most = options.reference.empty() ? 2 : 1;
  if (documents.size() > most)
    throw UsageError("one mesh is compared with one reference, but '" + run.in().names()[most] +
                     "' is an additional input");
  if (!options.reference.empty()) return run.in().read(options.reference).mesh;
  if (documents.size() == 2) {
    run.in().note_unit(unit_of(documents[1]));
    return std::move(documents[1].mesh);
  }
  throw UsageError(
      "name two files, a mesh and a reference, or give the reference with --reference");
}

/// Prints a note if signs of distances can be wrong. Merges equal positions of a soup, because the
/// faces at an edge or a vertex determine the sign there.
void prepare_for_signs(Mesh& reference, tool::Run& run) {
  join_soup(reference);
  const ManifoldReport report = check_manifold(reference);
  if (report.is_closed() && report.is_oriented()) return;
  run.say().note(prefixed("signs of distances from the reference can be wrong: ",
                          manifold_problem(reference, report, true)));
}

void compare_with_reference(const Options& options, tool::Run& run) {
  if (options.is_signed && options.per_vertex.empty())
    throw UsageError("--signed needs --per-vertex, which writes the distances");
  Mesh reference = read_reference(options, run);
  run.in().set_basis(diagonal_of(bounding_box(reference)));
  CompareOptions how = options.compare;
  how.distance = run.length(options.distance);
  const Comparison found = compare(run.document().mesh, reference, how, run.progress());

  run.report(entries_of(found));
  if (options.is_signed) prepare_for_signs(reference, run);
  if (!options.per_vertex.empty()) write_distances(reference, options, run);
  run.answer(!options.within || found.hausdorff <= run.length(*options.within));
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-compare",
                        "[OPTION]... [INPUT] [REFERENCE]",
                        "Measures the distances between a mesh and a reference",
                        {tool::Reads::meshes},
                        {tool::Writes::answer}};
  program.options.text("reference", &options.reference, "FILE",
                       "mesh or points to compare with (default: the second input)");
  program.options.length("distance", &options.distance,
                         "largest distance at which a point of the reference counts for "
                         "completeness; 1% is 1 % of the diagonal of its box");
  program.options.length("within", &options.within,
                         "exit with 1 if hausdorff is larger than this (default: no limit)");
  program.options
      .output_file(
          "per-vertex", &options.per_vertex,
          "write the mesh with the vertex property distance, the distance from the reference")
      .endings = written_endings();
  program.options.flag("signed", &options.is_signed,
                       "with --per-vertex: distances are negative inside the reference");
  program.options.integer("samples", &options.compare.samples, 0, 1000000000,
                          "number of sample points on each surface, in addition to the vertices");
  program.options.seed(&options.compare.seed);
  program.example = "tm-compare --get hausdorff result.ply target.ply";
  return program.run(argc, argv, [&](tool::Run& run) { compare_with_reference(options, run); });
}
