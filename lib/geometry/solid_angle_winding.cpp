#include "geometry/solid_angle_winding.h"

#include "support/parallel.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

constexpr std::size_t points_per_winding_task = 4;  ///< affects time only

}  // namespace

SolidAngleWinding::SolidAngleWinding(const Mesh& mesh) : mesh_(&mesh) {
  const Box box = bounding_box(mesh);
  largest_coordinate_ = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
}

BoundedWindingNumber SolidAngleWinding::sum(const Vec3& point,
                                            std::vector<Vec3>& directions) const {
  SolidAngleSum sum(point, largest_coordinate_);
  directions.resize(mesh_->positions.size());
  for (std::size_t v = 0; v < directions.size(); ++v)
    directions[v] = sum.direction(mesh_->positions[v]);
  for (const auto& [a, b, c] : mesh_->faces) sum.add(directions[a], directions[b], directions[c]);
  return sum.result();
}

BoundedWindingNumber SolidAngleWinding::operator()(const Vec3& point) const {
  std::vector<Vec3> directions;
  return sum(point, directions);
}

std::vector<BoundedWindingNumber> SolidAngleWinding::operator()(
    std::span<const Vec3> points) const {
  std::vector<BoundedWindingNumber> windings(points.size());
  parallel_for(points.size(), points_per_winding_task, [&](std::size_t first, std::size_t last) {
    std::vector<Vec3> directions;
    for (std::size_t i = first; i < last; ++i) windings[i] = sum(points[i], directions);
  });
  return windings;
}

}  // namespace transformesh
