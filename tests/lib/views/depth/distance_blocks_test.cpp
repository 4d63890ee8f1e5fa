// Fused depth maps of a ball, judged by its closed form.
#include "views/depth/distance_blocks.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/mesh_facts.h"
#include "helpers/view_maker.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

const view_maker::Frame frame{160, 120, 200};
const Box box(Vec3::Constant(-1.3), Vec3::Constant(1.3));

/// Returns the exact depth of the unit ball at the origin; 0 beside it.
float depth_of_ball(const PinholeCamera& camera, int x, int y) {
  const Vec3 ray = camera.ray(x, y);
  const double half = ray.dot(camera.center()), square = ray.squaredNorm();
  const double rest = half * half - square * (camera.center().squaredNorm() - 1);
  return rest > 0 ? static_cast<float>((-half - std::sqrt(rest)) / square) : 0;
}

DepthMap map_of_ball(const PinholeCamera& camera) {
  DepthMap map{GrayImage(frame.width, frame.height), 0.01};
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) map.depth.at(x, y) = depth_of_ball(camera, x, y);
  return map;
}

/// Views from above: the lower part of the ball is not observed.
std::vector<DepthSurface> surfaces_above() {
  std::vector<DepthSurface> surfaces;
  for (const Vec3& eye : {Vec3(0, -2, 4), Vec3(0, 2, 4), Vec3(2, 0, 4), Vec3(-2, 0, 4)}) {
    const PinholeCamera camera = view_maker::camera_at(eye, frame);
    surfaces.emplace_back(camera, map_of_ball(camera), 1);
  }
  return surfaces;
}

void check_open_surface(const Mesh& mesh) {
  const test::Count count = test::count(mesh);
  CHECK_FALSE(count.is_closed_and_oriented);
  CHECK(find_intersections(mesh).empty());
}

}  // namespace

TEST_CASE("the surface lies on the ball, faces outwards, and is open where no view shows it") {
  const Mesh mesh = march_blocks(fuse_distances(box, 0.04, surfaces_above()));
  REQUIRE(mesh.faces.size() > 3000);
  check_open_surface(mesh);
  std::size_t far = 0;
  double lowest = 1;
  double highest = -1;
  for (const Vec3& position : mesh.positions) {
    far += std::abs(position.norm() - 1) > 0.03 ? 1 : 0;
    lowest = std::min(lowest, position.z());
    highest = std::max(highest, position.z());
  }
  // A pixel is 0.02 wide; steep places that a single view shows are less accurate.
  CHECK(far < mesh.positions.size() / 20);
  CHECK(lowest > -0.7);
  CHECK(lowest < 0.5);
  CHECK(highest > 0.97);
  for (Index f = 0; f < mesh.faces.size(); ++f)
    CHECK(face_normal(mesh, f).dot(mesh.positions[mesh.faces[f][0]]) > 0);
}

TEST_CASE("a surface that one view claims in the free space of others vanishes") {
  std::vector<DepthSurface> surfaces = surfaces_above();
  const PinholeCamera camera = view_maker::camera_at(Vec3(1, 1, 4), frame);
  DepthMap wrong = map_of_ball(camera);
  for (int y = 50; y < 70; ++y)
    for (int x = 70; x < 90; ++x) wrong.depth.at(x, y) -= 0.25F;
  surfaces.emplace_back(camera, wrong, 1);
  const Mesh mesh = march_blocks(fuse_distances(box, 0.04, surfaces));
  for (const Vec3& position : mesh.positions) CHECK(position.norm() < 1.1);
}

TEST_CASE("values are unknown outside of blocks, and the same for any number of threads") {
  const DistanceBlocks blocks = fuse_distances(box, 0.04, surfaces_above());
  CHECK(std::isnan(blocks.value_or_unknown({0, 0, 0})));
  CHECK(std::isnan(blocks.value_or_unknown({1000000, 0, 0})));
  CHECK(blocks.values.size() == blocks.keys.size() * DistanceBlocks::size);
  CHECK(blocks.values.size() <
        blocks.grid.nodes[0] * blocks.grid.nodes[1] * blocks.grid.nodes[2] / 2);
  const Mesh mesh = march_blocks(blocks);
  const ThreadLimit limit(1);
  CHECK(march_blocks(fuse_distances(box, 0.04, surfaces_above())).positions == mesh.positions);
}

TEST_CASE("too many cells are refused") {
  CHECK_THROWS_AS(fuse_distances(box, 1e-8, surfaces_above()), UsageError);
}
