// One step of a morph between tiny meshes: vertices move at most as far as the clamp allows, and
// everything else stays.
#include "fuzz/tiny_mesh.h"
#include "mesh/local_measures.h"
#include "step/local_thickness.h"
#include "step/morph_step_query.h"
#include "step/target_query.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "transformesh/morph_step.h"

using namespace transformesh;
using namespace transformesh::fuzz;

namespace {

MorphStepOptions step_options(Choices& choices) {
  MorphStepOptions options;
  if (choices.flag()) options.distance = static_cast<MorphDistance>(choices.below(3));
  options.displace.time_step = choices.byte() / 16.0 - 8;
  options.displace.alpha = choices.byte() / 255.0;
  return options;
}

Target target_of(Choices& choices) {
  const bool has_thickness = choices.flag();
  const bool is_points = choices.flag();
  Mesh mesh = tiny_mesh(choices);
  if (is_points) mesh.faces.clear();
  Target target = make_target(std::move(mesh));
  if (has_thickness) {
    const double reach = diagonal_of(bounding_box(target.mesh));
    if (reach > 0) target.thickness = local_thickness(target, reach);
  }
  return target;
}

void check_movement(const Mesh& before, const Mesh& after, double alpha) {
  demand(before.faces == after.faces, "other faces");
  const HalfedgeLengths lengths = halfedge_lengths(before);
  for (std::size_t v = 0; v < before.positions.size(); ++v) {
    demand(after.positions[v].allFinite(), "a coordinate that is no number");
    const double moved = (after.positions[v] - before.positions[v]).norm();
    const double rounding = 1e-15 * before.positions[v].cwiseAbs().maxCoeff();
    demand(moved <= 2 * alpha * lengths.maximum * (1 + 1e-12) + rounding, "farther than clamped");
  }
}

}  // namespace

void transformesh::fuzz::run_target(std::string_view bytes) {
  Choices choices(bytes);
  MorphStepOptions options = step_options(choices);
  try {
    const Target target = target_of(choices);
    Mesh mesh = tiny_mesh(choices);
    const Mesh before = mesh;
    if (!target.thickness.empty()) {
      options.gap_edges = 1 + choices.below(8);
      options.largest_size = diagonal_of(bounding_box(mesh));
    }
    const TargetQuery query(target);
    morph_step(mesh, query, options);
    check_movement(before, mesh, options.displace.alpha);
  } catch (const InputError&) {
  } catch (const UsageError&) {
  } catch (const GoalError&) {
  }
}
