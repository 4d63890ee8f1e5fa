// Photographs of a block on a table without masks, judged by the true shapes.
#include "views/depth/dense_surface.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/mesh_facts.h"
#include "helpers/view_maker.h"
#include "mesh/edges.h"
#include "mesh/umbrellas.h"
#include "transformesh/intersect.h"
#include "views/photo/solid_texture.h"

using namespace transformesh;

namespace {

const view_maker::Frame frame{128, 96, 130};

/// The ball has radius 1 and its center at the origin; the table is the plane z = -0.8.
constexpr double table = -0.8;

double way_to_scene(const Vec3& eye, const Vec3& ray) {
  const double half = ray.dot(eye), square = ray.squaredNorm();
  const double rest = half * half - square * (eye.squaredNorm() - 1);
  const double to_table = ray.z() < 0 ? (table - eye.z()) / ray.z() : HUGE_VAL;
  return rest > 0 ? std::min(to_table, (-half - std::sqrt(rest)) / square) : to_table;
}

std::vector<View> photographs(int count) {
  const SolidTexture texture({.waves = 40, .finest = 0.2, .coarsest = 1});
  std::vector<View> views;
  for (int i = 0; i < count; ++i) {
    const double turn = 2 * 3.14159265358979 * i / count;
    const double height = i % 2 == 0 ? 0.9 : 0.45;
    const Vec3 eye = 4.5 * Vec3(std::cos(height) * std::cos(turn),
                                std::cos(height) * std::sin(turn), std::sin(height));
    View view;
    view.name = "view" + std::to_string(i);
    view.camera = view_maker::camera_at(eye, frame);
    GrayImage image(frame.width, frame.height);
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x) {
        const Vec3 ray = view.camera.ray(x, y);
        const double way = way_to_scene(eye, ray);
        if (way < 30) image.at(x, y) = texture.intensity_at(eye + way * ray);
      }
    view.image = std::move(image);
    views.push_back(std::move(view));
  }
  return views;
}

double distance_from_scene(const Vec3& point) {
  return std::min(std::abs(point.norm() - 1), std::abs(point.z() - table));
}

const Box box(Vec3(-1.6, -1.6, -1), Vec3(1.6, 1.6, 1.2));

}  // namespace

TEST_CASE("a ball on a table without masks: on the truth, complete from above, open, manifold") {
  const std::vector<View> views = photographs(16);
  const DenseSurface dense = dense_surface(views, {.box = box});
  const Mesh& mesh = dense.mesh;
  const double pixel = 4.5 / frame.focal_length;

  CHECK(find_umbrellas(mesh, Edges(mesh)).vertex_of.size() == mesh.positions.size());
  CHECK(find_intersections(mesh).empty());
  CHECK(dense.idle_views.empty());
  CHECK(dense.consistent > dense.pixels / 4);

  std::size_t near = 0;
  for (const Vec3& position : mesh.positions)
    near += distance_from_scene(position) < 1.5 * pixel ? 1 : 0;
  CHECK(static_cast<double>(near) > 0.9 * static_cast<double>(mesh.positions.size()));

  // Points of the ball's upper half and of the table beside it.
  std::size_t wanted = 0;
  std::size_t found = 0;
  const auto look_for = [&](const Vec3& point) {
    ++wanted;
    found += std::any_of(mesh.positions.begin(), mesh.positions.end(),
                         [&](const Vec3& p) { return (p - point).norm() < 1.5 * pixel; })
                 ? 1
                 : 0;
  };
  for (int i = 0; i < 20; ++i) {
    const double turn = 0.314159 * i;
    for (const double z : {0.0, 0.3, 0.6, 0.9}) {
      const double radius = std::sqrt(1 - z * z);
      look_for(Vec3(radius * std::cos(turn), radius * std::sin(turn), z));
    }
    look_for(Vec3(1.4 * std::cos(turn), 1.4 * std::sin(turn), table));
  }
  CHECK(static_cast<double>(found) > 0.85 * static_cast<double>(wanted));
}

TEST_CASE("a photograph of another place adds nothing, and is named") {
  std::vector<View> views = photographs(16);
  views[5].image = GrayImage(frame.width, frame.height, 90.0F);
  const DenseSurface dense = dense_surface(views, {.box = box});
  REQUIRE(dense.idle_views.size() == 1);
  CHECK(dense.idle_views[0] == "view5");
}

TEST_CASE("photographs that show nothing, and fewer than two, are refused") {
  std::vector<View> views = photographs(4);
  for (View& view : views) view.image = GrayImage(frame.width, frame.height, 90.0F);
  CHECK_THROWS_AS(dense_surface(views, {.box = box}), GoalError);
  views.resize(1);
  CHECK_THROWS_AS(dense_surface(views, {.box = box}), InputError);
}
