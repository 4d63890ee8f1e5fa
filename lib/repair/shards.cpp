#include "repair/shards.h"

#include <algorithm>

#include "transformesh/components.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// A component is a shard if its area is below this share of the total area. The area of a ball
/// with 1/300 of the diameter of a spherical model has this share. The volume of a shard is below
/// 4e-8 of the volume of a compact model (isoperimetric inequality). With 0, remains of cut faces
/// stay; with 1e-4, screws of a machine vanish.
constexpr double shard_share = 1e-5;

}  // namespace

double least_area(const Mesh& mesh) {
  const Components parts = connected_components(mesh);
  if (parts.components.size() < 2) return 0;
  std::vector<double> areas(parts.components.size(), 0);
  for (Index f = 0; f < mesh.faces.size(); ++f) areas[parts.of_face[f]] += face_area(mesh, f);
  const double least = shard_share * surface_area(mesh);
  return std::ranges::min(areas) < least ? least : 0;
}

}  // namespace transformesh
