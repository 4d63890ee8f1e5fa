#include "evolution/agreement.h"

#include <algorithm>

#include "evolution/loop/stages.h"
#include "evolution/morph_remedy.h"
#include "geometry/search/closest_point.h"
#include "step/target_query.h"
#include "support/number.h"
#include "support/parallel.h"
#include "transformesh/compare.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Number of sample points per surface. With more points, smaller disagreements are found; time is
/// proportional to their number.
constexpr std::size_t agreement_samples = 40000;

bool is_closed_manifold(const Mesh& mesh) {
  const ManifoldReport found = check_manifold(mesh);
  return found.is_manifold() && found.is_oriented() && found.is_closed();
}

std::string topology_fault(const Topology& topology, const Topology& expected, const Vec3& place) {
  return "components " + std::to_string(topology.components) + " and genus " +
         std::to_string(topology.genus) + ", but those of the target are " +
         std::to_string(expected.components) + " and " + std::to_string(expected.genus) +
         "; the surfaces are farthest apart" + at_place(place);
}

std::string distance_fault(const Farthest& of_mesh, const Farthest& of_target, double longest) {
  if (of_mesh.distance > longest / 2) {
    return "the mesh is up to " + significant(of_mesh.distance, 3) +
           " away from the target, more than half the longest edge," + at_place(of_mesh.point);
  }
  if (of_target.distance > longest) {
    return "parts of the target are up to " + significant(of_target.distance, 3) +
           " away from the mesh, more than the longest edge," + at_place(of_target.point);
  }
  return {};
}

}  // namespace

MorphGoal goal_of(const Target& target, const Progress& progress) {
  if (!target.is_mesh() || !is_closed_manifold(target.mesh)) return {};
  Document document;
  document.mesh.positions = target.mesh.positions;
  document.mesh.faces = target.mesh.faces;
  try {
    const CleanedTopology cleaned = clean_in_place(document, progress);
    if (cleaned.pairs > 0) return {};
    MorphGoal goal{cleaned.topology, 0, {}};
    const std::size_t all = connected_components(target.mesh).components.size();
    goal.left_out = all - std::min(all, cleaned.topology.components);
    if (goal.left_out > 0) goal.without_those = make_target(std::move(document.mesh));
    return goal;
  } catch (const InputError&) {
  } catch (const GoalError&) {
  }
  return {};
}

Agreement agreement(const Mesh& mesh, const Topology& topology, const TargetQuery& query,
                    const MorphGoal& goal, const Progress& progress) {
  const Target& target = query.target();
  if (!target.is_mesh()) return {};
  progress("farthest point");
  const CompareOptions options{.samples = agreement_samples};
  const ClosestPointQuery& surface = query.surface();
  Farthest of_mesh, of_target;
  parallel_invoke(
      [&] { of_mesh = farthest_from(surface, mesh, options); },
      [&] { of_target = farthest_from(ClosestPointQuery(mesh), goal.of(target).mesh, options); });
  const double longest = edge_lengths(mesh).maximum;
  const bool differs = goal.topology && *goal.topology != topology;
  const bool is_of_mesh =
      differs ? of_mesh.distance > of_target.distance : of_mesh.distance > longest / 2;
  const Farthest& worst = is_of_mesh ? of_mesh : of_target;
  Agreement result{{}, {}, of_mesh.distance, of_target.distance};
  result.mismatch = {worst.point, worst.distance, !is_of_mesh,
                     longest,     differs,        goal.topology.has_value()};
  result.fault = differs ? topology_fault(topology, *goal.topology, worst.point)
                         : distance_fault(of_mesh, of_target, longest);
  return result;
}

}  // namespace transformesh
