#include "tm/evolution/agreement.h"

#include "tm/evolution/csv_row.h"
#include "tm/geometry/compare.h"
#include "tm/mesh/manifold.h"
#include "tm/mesh/measure.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

constexpr std::size_t samples = 40000;

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

std::string distance_fault(const Comparison& found, double longest) {
  if (found.hausdorff_to_reference > longest / 2) {
    return "up to " + significant(found.hausdorff_to_reference, 3) +
           " away from the target, more than half the longest edge," + at(found.farthest_of_mesh) +
           ": take shorter edges";
  }
  if (found.hausdorff_from_reference > longest) {
    return "parts of the target are missed by up to " +
           significant(found.hausdorff_from_reference, 3) + ", more than the longest edge," +
           at(found.farthest_of_reference) +
           ": take shorter edges, and a source that overlaps all of the target";
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

Agreement agreement(const Mesh& mesh, const Topology& topology, const Target& target,
                    const std::optional<Topology>& expected, const Progress& progress) {
  if (!target.is_mesh()) return {};
  const Comparison found = compare(mesh, target.mesh, {.samples = samples}, progress);
  Agreement result{{}, found.hausdorff_to_reference, found.hausdorff_from_reference};
  const bool goes_out = found.hausdorff_to_reference > found.hausdorff_from_reference;
  if (expected && *expected != topology) {
    result.fault = topology_fault(topology, *expected,
                                  goes_out ? found.farthest_of_mesh : found.farthest_of_reference);
  } else {
    result.fault = distance_fault(found, edge_lengths(mesh).maximum);
  }
  return result;
}

}  // namespace transformesh
