/// tm-info: reports counts, topology, sizes, and the quality of the triangles of a mesh.
#include <cmath>

#include "frame/run.h"
#include "io/document/unit.h"
#include "io/formats/file_format.h"
#include "io/polygons/merge_polygons.h"
#include "transformesh/errors.h"
#include "transformesh/velocity.h"

namespace {

using namespace transformesh;

/// Throws InputError if a size is not finite and the report prints it. If `only` is not empty, the
/// report prints only this key.
void check_size(const std::string& key, const Value& value, const std::string& only) {
  const auto* size = std::get_if<double>(&value);
  if (size == nullptr || std::isfinite(*size) || !(only.empty() || only == key)) return;
  throw InputError("the " + key +
                   " of the mesh is beyond the range of double precision: scale the mesh down, or "
                   "ask for another value with --get");
}

// Writes the mesh with the property `curvature`: the mean curvature at each vertex.
void write_curvatures(const std::string& path, tool::Run& run) {
  Document& document = run.document();
  std::vector<double> curvatures = mean_curvatures(document.mesh);
  document.mesh.vertex_columns.get("curvature", document.style.coordinate, curvatures.size())
      .values = std::move(curvatures);
  run.out().write_mesh_file(path, std::move(document));
}

std::string unit_name(const Document& document) {
  const Unit* unit = unit_of(document);
  return unit == nullptr ? "unknown" : std::string(unit->name);
}

/// Returns the entries of the report. With `keeps_polygons`, a polygon counts as one face, and its
/// diagonals do not count as edges.
Entries described(const Mesh& mesh, bool keeps_polygons) {
  Entries entries = transformesh::describe(mesh);
  if (!keeps_polygons) return entries;
  const PolygonCount count = count_polygons(mesh.face_columns);
  for (auto& [key, value] : entries)
    if (key == "faces" || key == "edges")
      std::get<std::size_t>(value) -= count.triangles - count.polygons;
  entries.emplace_back("polygons", count.polygons);
  return entries;
}

void describe(const std::string& per_vertex, bool with_unit, tool::Run& run) {
  const Mesh& mesh = run.document().mesh;
  run.progress()("measuring");
  if (with_unit) run.report("unit", unit_name(run.document()));
  const Entries entries = described(mesh, run.program().common.keep_polygons);
  for (const auto& [key, value] : entries) check_size(key, value, *run.program().output.only_key);
  run.report(entries);
  if (!per_vertex.empty()) write_curvatures(per_vertex, run);
}

}  // namespace

int main(int argc, char** argv) {
  std::string key;
  std::string per_vertex;
  bool with_unit = false;
  tool::Program program{"tm-info",
                        "[OPTION]... [INPUT]",
                        "Describes a mesh: counts, topology, sizes, triangle quality",
                        {tool::Reads::mesh},
                        {tool::Writes::report}};
  program.input.soups = tool::Soups::reported;
  program.options.choice(
      "get", &key,
      {"vertices", "faces", "edges", "components", "genus", "boundary_loops", "area", "volume",
       "bbox_min", "bbox_max", "edge_mean", "edge_min", "edge_max", "angle_min", "angle_min_mean",
       "valence6", "unit", "polygons"},
      "print only the value of this key");
  program.input.may_keep_polygons = true;
  program.options.flag("units", &with_unit, "also report the unit of lengths, or unknown");
  program.options
      .output_file("per-vertex", &per_vertex,
                   "write the mesh with the vertex property curvature, the mean curvature")
      .endings = written_endings();
  program.output.only_key = &key;
  program.settle = [&] { program.common.keep_polygons |= key == "polygons"; };
  program.example = "tm-info --get volume mesh.ply";
  return program.run(
      argc, argv, [&](tool::Run& run) { describe(per_vertex, with_unit || key == "unit", run); });
}
