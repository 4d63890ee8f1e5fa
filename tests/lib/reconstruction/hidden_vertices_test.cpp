#include "reconstruction/hidden_vertices.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "helpers/ball_photographs.h"
#include "helpers/shapes.h"

using namespace transformesh;

namespace {

constexpr double distance = 5;

/// Two views of the unit sphere from this distance, in the directions z and x.
PhotoScene two_views(int size) {
  PhotoScene scene;
  for (const double angle_deg : {0, 90}) {
    View view;
    view.camera.intrinsics << 100, 0, (size - 1) / 2.0, 0, 100, (size - 1) / 2.0, 0, 0, 1;
    view.camera.rotation =
        Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180, Vec3::UnitY()).toRotationMatrix();
    view.camera.translation = {0, 0, distance};
    view.image = GrayImage(size, size);
    scene.views.push_back(view);
  }
  scene.pairs = {{0, 1, 90}};
  return scene;
}

}  // namespace

TEST_CASE("an unobserved vertex of a sphere is hidden if it is beyond both tangent planes") {
  const Mesh mesh = test::icosphere(4);
  const PhotoScene scene = two_views(200);
  const Vec3 first = scene.views[0].camera.center().normalized();
  const Vec3 second = scene.views[1].camera.center().normalized();
  const std::size_t count = mesh.positions.size();
  const std::vector<bool> is_hidden = hidden_vertices(mesh, std::vector<bool>(count), scene, 0);
  for (std::size_t v = 0; v < count; ++v) {
    // A camera sees the cap of a sphere above the plane in which its rays touch the sphere.
    const Vec3& p = mesh.positions[v];
    const double height = std::min(p.dot(first), p.dot(second));
    if (std::abs(height - 1 / distance) > 0.01) CHECK(is_hidden[v] == (height > 1 / distance));
  }
  for (const bool hidden : hidden_vertices(mesh, std::vector<bool>(count, true), scene, 0))
    CHECK_FALSE(hidden);
}

TEST_CASE("vertices outside of an image, and vertices that only one view of a pair faces, stay") {
  const Mesh mesh = test::icosphere(4);
  const std::vector<bool> none(mesh.positions.size());
  PhotoScene scene = two_views(3);
  for (const bool hidden : hidden_vertices(mesh, none, scene, 0)) CHECK_FALSE(hidden);
  scene = two_views(200);
  scene.pairs.clear();
  for (const bool hidden : hidden_vertices(mesh, none, scene, 0)) CHECK_FALSE(hidden);
}
