#include "tm/evolution/agreement.h"

#include "tm/geometry/compare.h"
#include "tm/mesh/manifold.h"
#include "tm/mesh/measure.h"
#include "tm/support/error.h"
#include "tm/support/number.h"
#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t samples = 40000;
constexpr double few_edges = 3;

bool is_closed_manifold(const Mesh& mesh) {
  const ManifoldReport found = check_manifold(mesh);
  return found.is_manifold() && found.is_oriented() && found.is_closed();
}

std::string at(const Vec3& point) {
  std::string text = " at (" + significant(point.x(), 4) + ", " + significant(point.y(), 4);
  return text.append(", ").append(significant(point.z(), 4)).append(")");
}

std::string topology_fault(const Topology& topology, const Topology& expected, const Vec3& place) {
  return "components " + std::to_string(topology.components) + " and genus " +
         std::to_string(topology.genus) + ", but those of the target are " +
         std::to_string(expected.components) + " and " + std::to_string(expected.genus) +
         ": edges have to be shorter than half the gaps of the target, and the source has to "
         "overlap all of it; they are farthest apart" +
         at(place);
}

// What gets closer, by how far it is in edges: shorter edges help over a few of them.
std::string remedy(double distance, double longest, bool has_clean_target) {
  if (!has_clean_target)
    return ": the target is open, no manifold, or crosses itself there or elsewhere, so that no "
           "surface without crossings lies on all of it; clean it, or close its holes";
  if (distance > few_edges * longest)
    return ": take more --iterations if they ended there, else a source that overlaps all of the "
           "target";
  return ": take shorter edges";
}

std::string distance_fault(const Farthest& of_mesh, const Farthest& of_target, double longest,
                           bool has_clean_target) {
  if (of_mesh.distance > longest / 2) {
    return "up to " + significant(of_mesh.distance, 3) +
           " away from the target, more than half the longest edge," + at(of_mesh.point) +
           remedy(of_mesh.distance, longest, has_clean_target);
  }
  if (of_target.distance > longest) {
    return "parts of the target are missed by up to " + significant(of_target.distance, 3) +
           ", more than the longest edge," + at(of_target.point) +
           remedy(of_target.distance, longest, has_clean_target);
  }
  return {};
}

}  // namespace

std::optional<Topology> topology_of_target(const Target& target, const Progress& progress) {
  if (!target.is_mesh() || !is_closed_manifold(target.mesh)) return std::nullopt;
  Document document;
  document.mesh.positions = target.mesh.positions;
  document.mesh.faces = target.mesh.faces;
  try {
    const CleanedTopology cleaned = clean_in_place(document, progress);
    if (cleaned.pairs == 0) return cleaned.topology;
  } catch (const InputError&) {
  } catch (const GoalError&) {
  }
  return std::nullopt;
}

Agreement agreement(const Mesh& mesh, const Topology& topology, const TargetQuery& query,
                    const std::optional<Topology>& expected, const Progress& progress) {
  const Target& target = query.target();
  if (!target.is_mesh()) return {};
  progress("farthest point");
  const CompareOptions options{.samples = samples};
  const ClosestPointQuery& surface = query.surface();
  Farthest of_mesh, of_target;
  parallel_invoke(
      [&] { of_mesh = farthest_from(surface, mesh, options); },
      [&] { of_target = farthest_from(ClosestPointQuery(mesh), target.mesh, options); });
  Agreement result{{}, of_mesh.distance, of_target.distance};
  if (expected && *expected != topology) {
    const bool is_outside = of_mesh.distance > of_target.distance;
    result.fault =
        topology_fault(topology, *expected, is_outside ? of_mesh.point : of_target.point);
  } else {
    result.fault =
        distance_fault(of_mesh, of_target, edge_lengths(mesh).maximum, expected.has_value());
  }
  return result;
}

}  // namespace transformesh
