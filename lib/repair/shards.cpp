#include "repair/shards.h"

#include <algorithm>

#include "transformesh/components.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Share of the whole area below which a component is a shard: a ball of 1/300 of the diameter of
/// the model. By the isoperimetric inequality its volume is less than 4e-8 of a compact model.
/// Without it cut faces leave crumbs; ten times as much would drop screws of a machine.
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
