#include "views/hull/needed_components.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "helpers/view_maker.h"
#include "transformesh/components.h"
#include "views/hull/hull_values.h"

using namespace transformesh;
using namespace view_maker;

namespace {

/// Views with silhouettes that show the union of balls.
std::vector<View> views_of_balls(const std::vector<Vec3>& centers, double radius) {
  std::vector<View> views;
  for (const Vec3& eye : ring_of_eyes(9, 500, 25)) {
    View view = ball_view(eye, centers.front(), radius);
    for (const Vec3& center : centers) {
      GrayImage silhouette = view.silhouette;
      const GrayImage other = ball_view(eye, center, radius).silhouette;
      for (std::size_t i = 0; i < silhouette.pixels.size(); ++i)
        silhouette.pixels[i] = std::max(silhouette.pixels[i], other.pixels[i]);
      view.silhouette = silhouette;
    }
    views.push_back(view);
  }
  return views;
}

std::size_t components_of(const Mesh& mesh) { return connected_components(mesh).components.size(); }

Mesh ball_at(const Vec3& center, double radius) {
  return test::moved(test::scaled(test::icosphere(3), radius), center);
}

void append(Mesh& mesh, const Mesh& other) {
  const auto offset = static_cast<Index>(mesh.positions.size());
  for (const Vec3& p : other.positions) mesh.positions.push_back(p);
  for (const auto& [a, b, c] : other.faces)
    mesh.faces.push_back({a + offset, b + offset, c + offset});
}

}  // namespace

TEST_CASE("an object stays, and a component that is covered in every view is dropped") {
  const std::vector<View> views = views_of_balls({Vec3(0, 0, 0)}, 40);
  Mesh mesh = ball_at(Vec3(0, 0, 0), 40);
  append(mesh, ball_at(Vec3(80, 0, 0), 10));
  append(mesh, ball_at(Vec3(0, 0, 0), 20));
  CHECK(drop_unneeded_components(mesh, views) == 1);
  CHECK(components_of(mesh) == 2);
  for (const Vec3& p : mesh.positions)
    CHECK((std::abs(p.norm() - 40) < 1 || std::abs((p - Vec3(80, 0, 0)).norm() - 10) < 1));
}

TEST_CASE("cavities and crumbs are dropped") {
  const std::vector<View> views = views_of_balls({Vec3(0, 0, 0)}, 40);
  Mesh mesh = ball_at(Vec3(0, 0, 0), 40);
  append(mesh, ball_at(Vec3(80, 0, 0), 3));
  Mesh cavity = ball_at(Vec3(80, 0, 0), 20);
  for (auto& face : cavity.faces) std::swap(face[0], face[1]);
  append(mesh, cavity);
  CHECK(drop_unneeded_components(mesh, views) == 2);
  CHECK(components_of(mesh) == 1);
}

TEST_CASE("the hull of two balls keeps both, and no phantom") {
  const std::vector<Vec3> centers{Vec3(-45, 0, 0), Vec3(45, 0, 0)};
  const std::vector<View> views = views_of_balls(centers, 30);
  Mesh mesh = visual_hull(views, {.resolution = 60, .keep = 0}).mesh;
  const std::size_t all = components_of(mesh);
  CHECK(drop_unneeded_components(mesh, views) == all - 2);
  for (const Component& part : connected_components(mesh).components) CHECK(part.volume > 1e5);
}
