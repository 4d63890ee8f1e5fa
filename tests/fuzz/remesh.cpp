// Remeshing: an embedded manifold stays embedded and keeps its genus. Coordinates are plain,
// because sheets less than a rounding error apart may end up intersecting.
#include "transformesh/remesh.h"

#include "fuzz/tiny_mesh.h"
#include "geometry/numbers/predicates.h"
#include "mesh/coordinate_spacing.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::fuzz;

namespace {

RemeshOptions remesh_options(Choices& choices, const Mesh& mesh) {
  RemeshOptions options;
  const double diagonal = diagonal_of(bounding_box(mesh));
  options.max_edge = diagonal * (0.15 + choices.byte() / 256.0);
  options.min_edge = options.max_edge / (1.5 + choices.byte() / 64.0);
  options.iterations = static_cast<int>(choices.below(4));
  options.flip = static_cast<FlipRule>(choices.below(3));
  options.smoothing = static_cast<Smoothing>(choices.below(4));
  const bool is_smoothed = options.smoothing > Smoothing::tangential;
  if (is_smoothed) options.smooth_first = choices.byte() / 255.0;
  options.feature_angle_deg = choices.flag() ? 1 + choices.below(180) : 180;
  options.keep_border = choices.flag();
  options.project = choices.flag();
  options.curved = choices.flag();
  if (choices.flag()) options.min_film = options.min_edge * choices.byte() / 256.0;
  if (choices.flag()) options.adaptive_error = diagonal * (1 + choices.byte()) / 1024;
  if (choices.flag()) options.coordinate = Scalar::float32;
  return options;
}

bool is_embedded(const Mesh& mesh) {
  const ManifoldReport report = check_manifold(mesh);
  return report.is_manifold() && report.is_oriented() && degenerate_faces(mesh).empty() &&
         find_intersections(mesh).empty();
}

struct Topology {
  bool is_closed;
  std::size_t components, boundary_loops;
  long genus;
};

Topology topology_of(const Mesh& mesh) {
  const ManifoldReport report = check_manifold(mesh);
  const Components components = connected_components(mesh);
  return {report.is_closed(), components.components.size(), report.boundary_loops,
          components.genus()};
}

void check_result(const Mesh& mesh, const RemeshResult& result, const Topology& before) {
  const std::string problem =
      manifold_problem(mesh, check_manifold(mesh), before.is_closed).sentence;
  demand(problem.empty(), problem);
  demand(find_intersections(mesh).empty(), "a crossing was made");
  const Topology after = topology_of(mesh);
  demand(after.components + result.components_removed.count == before.components,
         "other components");
  if (result.components_removed.count > 0) return;
  demand(after.genus == before.genus, "another genus");
  demand(after.boundary_loops == before.boundary_loops, "other borders");
}

}  // namespace

void transformesh::fuzz::run_target(std::string_view bytes) {
  constexpr std::size_t option_bytes = 12;
  Choices option_choices(bytes.substr(0, option_bytes));
  Choices mesh_choices(bytes.substr(std::min(option_bytes, bytes.size())));
  Mesh mesh = tiny_mesh(mesh_choices, Coordinates::plain);
  if (mesh.faces.empty()) return;
  const RemeshOptions options = remesh_options(option_choices, mesh);
  try {
    round_positions(mesh, options.coordinate);
  } catch (const GoalError&) {
    return;  // floats are too coarse for this mesh
  }
  if (!is_embedded(mesh)) return;
  const Topology before = topology_of(mesh);
  try {
    const RemeshResult result = remesh(mesh, options);
    check_result(mesh, result, before);
  } catch (const GoalError&) {  // all components are smaller than the shortest edge
  } catch (const UsageError&) {
  }
}
