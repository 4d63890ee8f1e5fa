/// tm-info: what a mesh is: counts, topology, sizes, and the quality of its triangles.
#include <cmath>

#include "frame/run.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "transformesh/velocity.h"

namespace {

using namespace transformesh;

std::vector<double> coordinates(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

void report_topology(const Mesh& mesh, std::size_t edges, tool::Run& run) {
  std::size_t boundary_loops = 0;
  const Components found = connected_components(mesh);
  for (const Component& component : found.components) boundary_loops += component.boundary_loops;
  run.report("vertices", mesh.positions.size());
  run.report("faces", mesh.faces.size());
  run.report("edges", edges);
  run.report("components", found.components.size());
  run.report("genus", found.genus());
  run.report("boundary_loops", boundary_loops);
}

// What is not asked for may be beyond what numbers hold.
void report_size(const std::string& key, double size, tool::Run& run) {
  const std::string& only = *run.program().only_key;
  if (!std::isfinite(size) && (only.empty() || only == key))
    throw InputError("the " + key +
                     " of the mesh is beyond what a number can hold: scale the mesh down, or ask "
                     "for something else with --get");
  run.report(key, size);
}

// The mesh with the mean curvature at every vertex.
void write_curvatures(const std::string& path, tool::Run& run) {
  Document& document = run.document();
  std::vector<double> curvatures = mean_curvatures(document.mesh);
  document.mesh.vertex_columns.get("curvature", document.style.coordinate, curvatures.size())
      .values = std::move(curvatures);
  run.write_mesh_file(path, std::move(document));
}

void describe(const std::string& per_vertex, tool::Run& run) {
  const Mesh& mesh = run.document().mesh;
  run.progress()("measuring");
  const EdgeLengths lengths = edge_lengths(mesh);
  report_topology(mesh, lengths.count, run);

  const Box box = bounding_box(mesh);
  report_size("area", surface_area(mesh), run);
  report_size("volume", volume(mesh), run);
  run.report("bbox_min", coordinates(box.minimum));
  run.report("bbox_max", coordinates(box.maximum));

  const Angles smallest = angles(mesh);
  report_size("edge_mean", lengths.mean, run);
  report_size("edge_min", lengths.minimum, run);
  report_size("edge_max", lengths.maximum, run);
  run.report("angle_min", smallest.minimum_deg);
  run.report("angle_min_mean", smallest.minimum_mean_deg);
  run.report("valence6", valence_six_share(mesh));
  if (!per_vertex.empty()) write_curvatures(per_vertex, run);
}

}  // namespace

int main(int argc, char** argv) {
  std::string key;
  std::string per_vertex;
  tool::Program program{"tm-info", "[OPTION]... [INPUT]",
                        "Describes a mesh: counts, topology, sizes, triangle quality",
                        tool::Reads::mesh, tool::Writes::report};
  program.soups = tool::Soups::reported;
  program.choice("get", &key,
                 {"vertices", "faces", "edges", "components", "genus", "boundary_loops", "area",
                  "volume", "bbox_min", "bbox_max", "edge_mean", "edge_min", "edge_max",
                  "angle_min", "angle_min_mean", "valence6"},
                 "print the value of this key only");
  program.text("per-vertex", &per_vertex, "FILE",
               "write the mesh with the property curvature: the mean curvature at each vertex");
  program.only_key = &key;
  return program.run(argc, argv, [&](tool::Run& run) { describe(per_vertex, run); });
}
