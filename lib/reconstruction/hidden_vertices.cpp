#include "reconstruction/hidden_vertices.h"

#include <algorithm>

#include "transformesh/measure.h"

namespace transformesh {
namespace {

class FacingView {
 public:
  FacingView(const View& view, double least_cosine)
      : projection_(view.camera.projection()),
        center_(view.camera.center()),
        width_(view.image.width),
        height_(view.image.height),
        least_cosine_(least_cosine) {}

  bool faces(const Vec3& point, const Vec3& normal) const {
    const Vec3 q = projection_.leftCols<3>() * point + projection_.col(3);
    const bool is_inside = q.z() > 0 && q.x() > -0.5 * q.z() && q.x() < (width_ - 0.5) * q.z() &&
                           q.y() > -0.5 * q.z() && q.y() < (height_ - 0.5) * q.z();
    const Vec3 ray = center_ - point;
    return is_inside && ray.dot(normal) > least_cosine_ * ray.norm();
  }

 private:
  Eigen::Matrix<double, 3, 4, Eigen::DontAlign> projection_;
  Vec3 center_;
  double width_, height_, least_cosine_;
};

}  // namespace

std::vector<bool> hidden_vertices(const Mesh& mesh, const std::vector<bool>& is_observed,
                                  const PhotoScene& scene, double least_cosine) {
  std::vector<FacingView> views;
  for (const View& view : scene.views) views.emplace_back(view, least_cosine);
  const std::vector<Vec3> normals = vertex_normals(mesh);
  std::vector<bool> is_facing(views.size());
  std::vector<bool> is_hidden(mesh.positions.size());
  for (std::size_t v = 0; v < is_hidden.size(); ++v) {
    if (is_observed[v]) continue;
    for (std::size_t i = 0; i < views.size(); ++i)
      is_facing[i] = views[i].faces(mesh.positions[v], normals[v]);
    is_hidden[v] = std::ranges::any_of(scene.pairs, [&](const ViewPair& pair) {
      return is_facing[pair.first] && is_facing[pair.second];
    });
  }
  return is_hidden;
}

}  // namespace transformesh
