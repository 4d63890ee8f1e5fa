#include "entries/entries.h"
#include "transformesh/components.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

std::vector<double> coordinates(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

}  // namespace

Entries describe(const Mesh& mesh) {
  const EdgeLengths lengths = edge_lengths(mesh);
  const Components found = connected_components(mesh);
  std::size_t boundary_loops = 0;
  for (const Component& component : found.components) boundary_loops += component.boundary_loops;
  const Box box = bounding_box(mesh);
  const Angles smallest = angles(mesh);
  return {{"vertices", mesh.positions.size()},
          {"faces", mesh.faces.size()},
          {"edges", lengths.count},
          {"components", found.components.size()},
          {"genus", found.genus()},
          {"boundary_loops", boundary_loops},
          {"area", surface_area(mesh)},
          {"volume", volume(mesh)},
          {"bbox_min", coordinates(box.min())},
          {"bbox_max", coordinates(box.max())},
          {"edge_mean", lengths.mean},
          {"edge_min", lengths.minimum},
          {"edge_max", lengths.maximum},
          {"angle_min", smallest.minimum_deg},
          {"angle_min_mean", smallest.minimum_mean_deg},
          {"valence6", valence_six_share(mesh)}};
}

void append(Entries& entries, const Entries& more) {
  entries.insert(entries.end(), more.begin(), more.end());
}

}  // namespace transformesh
