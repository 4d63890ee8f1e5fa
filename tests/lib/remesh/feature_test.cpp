#include <cmath>
#include <numbers>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "transformesh/intersect.h"
#include "transformesh/measure.h"
#include "transformesh/remesh.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

RemeshOptions with_features(double min_edge, double max_edge) {
  RemeshOptions options;
  options.min_edge = min_edge;
  options.max_edge = max_edge;
  options.iterations = 5;
  options.feature_angle_deg = 40;
  return options;
}

/// The length of the edges that are sharper than an angle, and the number of vertices at which
/// other than two of them end.
struct SharpEdges {
  double length = 0;
  std::map<Index, int> at;

  SharpEdges(const Mesh& mesh, double angle_deg) {
    std::map<std::pair<Index, Index>, std::vector<Index>> faces;
    for (Index f = 0; f < mesh.faces.size(); ++f) {
      for (std::size_t i = 0; i < 3; ++i)
        faces[std::minmax(mesh.faces[f][i], mesh.faces[f][(i + 1) % 3])].push_back(f);
    }
    for (const auto& [edge, sides] : faces) {
      if (sides.size() != 2) continue;
      const double cosine =
          face_normal(mesh, sides[0]).normalized().dot(face_normal(mesh, sides[1]).normalized());
      if (cosine > std::cos(angle_deg * std::numbers::pi / 180)) continue;
      length += (mesh.positions[edge.first] - mesh.positions[edge.second]).norm();
      ++at[edge.first];
      ++at[edge.second];
    }
  }
  std::size_t corners() const {
    std::size_t count = 0;
    for (const auto& [vertex, edges] : at) count += edges != 2;
    return count;
  }
};

/// The number of coordinates of a point that lie on the planes of a box, and its largest distance
/// outside of the box.
struct OnBox {
  int planes = 0;
  double outside = 0;

  OnBox(const Vec3& p, const Vec3& low, const Vec3& high) {
    for (int i = 0; i < 3; ++i) {
      planes += std::abs(p[i] - low[i]) < 1e-13 || std::abs(p[i] - high[i]) < 1e-13;
      outside = std::max({outside, low[i] - p[i], p[i] - high[i]});
    }
  }
};

const Vec3 low(0, 0, 0);
const Vec3 high(1, 2, 3);

void check_box(const Mesh& mesh, const Eigen::Matrix3d& back) {
  CHECK(is_oriented_manifold(mesh));
  CHECK(is_closed(mesh));
  CHECK(find_intersections(mesh).empty());
  CHECK(volume(mesh) == doctest::Approx(6).epsilon(1e-12));
  CHECK(surface_area(mesh) == doctest::Approx(22).epsilon(1e-12));
  std::array<int, 4> on{};
  for (const Vec3& p : mesh.positions) {
    const OnBox place(back * p, low, high);
    CHECK(place.outside < 1e-13);
    ++on[static_cast<std::size_t>(place.planes)];
  }
  CHECK(on[0] == 0);  // every vertex on a side
  CHECK(on[3] == 8);  // vertices at all corners
  const SharpEdges sharp(mesh, 40);
  CHECK(sharp.length == doctest::Approx(24).epsilon(1e-12));
  CHECK(sharp.corners() == 8);
}

/// A prism of n sides that approximates a cylinder of radius 1 and height 2. Each cap is an
/// umbrella around a vertex in its center.
Mesh cylinder(Index n) {
  Mesh mesh;
  for (Index i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    for (const double z : {0.0, 2.0})
      mesh.positions.emplace_back(std::cos(angle), std::sin(angle), z);
  }
  mesh.positions.emplace_back(0, 0, 0);
  mesh.positions.emplace_back(0, 0, 2);
  for (Index i = 0; i < n; ++i) {
    const Index a = 2 * i;
    const Index b = 2 * ((i + 1) % n);
    mesh.faces.insert(mesh.faces.end(),
                      {{a, b, b + 1}, {a, b + 1, a + 1}, {2 * n, b, a}, {2 * n + 1, a + 1, b + 1}});
  }
  return mesh;
}

}  // namespace

TEST_CASE("a box stays a box: straight edges, corners, volume") {
  Mesh mesh = cuboid(low, high);
  SUBCASE("finer") { remesh(mesh, with_features(0.07, 0.15)); }
  SUBCASE("finer, then coarser") {
    remesh(mesh, with_features(0.05, 0.1));
    remesh(mesh, with_features(0.3, 0.6));
  }
  SUBCASE("with minimum angles") {
    RemeshOptions options = with_features(0.1, 0.2);
    options.flip = FlipRule::angle;
    remesh(mesh, options);
  }
  SUBCASE("with the Laplacian") {
    RemeshOptions options = with_features(0.1, 0.2);
    options.smoothing = Smoothing::laplace;
    options.smooth_first = 0.3;
    remesh(mesh, options);
  }
  SUBCASE("by an error bound") {
    RemeshOptions options = with_features(0.1, 0.5);
    options.adaptive_error = 0.01;
    remesh(mesh, options);
    CHECK(edge_lengths(mesh).mean > 0.3);  // kept edges do not cause short edges
  }
  check_box(mesh, Eigen::Matrix3d::Identity());
  CHECK(angles(mesh).minimum_deg > 18);
}

TEST_CASE("a box in any position stays one") {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.8, Vec3(1, 2, 3).normalized()).matrix();
  Mesh mesh = cuboid(low, high);
  for (Vec3& p : mesh.positions) p = turn * p;
  remesh(mesh, with_features(0.1, 0.2));
  check_box(mesh, turn.transpose());
}

TEST_CASE("without the option the box is rounded off") {
  Mesh mesh = cuboid(low, high);
  RemeshOptions options = with_features(0.1, 0.2);
  options.feature_angle_deg = 180;
  options.smoothing = Smoothing::laplace;
  options.smooth_first = 0.3;
  remesh(mesh, options);
  CHECK(volume(mesh) < 5.99);
  CHECK(SharpEdges(mesh, 40).length < 23);
}

TEST_CASE("a cylinder keeps its rims and flat caps") {
  const Index sides = 96;
  Mesh mesh = cylinder(sides);
  const double before = volume(mesh);
  remesh(mesh, with_features(0.06, 0.13));
  CHECK(is_oriented_manifold(mesh));
  CHECK(find_intersections(mesh).empty());
  CHECK(std::abs(volume(mesh) / before - 1) < 2e-3);
  CHECK(angles(mesh).minimum_deg > 15);

  // two closed lines near the circles, in the planes of the caps
  const SharpEdges sharp(mesh, 40);
  CHECK(sharp.corners() == 0);
  CHECK(sharp.length == doctest::Approx(4 * std::numbers::pi).epsilon(5e-3));
  for (const auto& [vertex, edges] : sharp.at) {
    const Vec3& p = mesh.positions[vertex];
    CHECK((std::abs(p.z()) < 1e-13 || std::abs(p.z() - 2) < 1e-13));
    CHECK(std::hypot(p.x(), p.y()) == doctest::Approx(1).epsilon(5e-3));
  }
  double highest = 0;
  for (const Vec3& p : mesh.positions) highest = std::max(highest, std::abs(p.z() - 1));
  CHECK(highest <= 1 + 1e-13);
}

TEST_CASE("an open box keeps its border to the bit, and its edges") {
  Mesh mesh = cuboid(low, high);
  remesh(mesh, with_features(0.15, 0.3));
  std::erase_if(mesh.faces, [&](const Face& face) {
    return mesh.positions[face[0]].z() > 2.999 && mesh.positions[face[1]].z() > 2.999 &&
           mesh.positions[face[2]].z() > 2.999;
  });
  const auto border_of = [](const Mesh& open) {
    std::set<std::array<double, 6>> ends;
    for (const auto& [edge, faces] : edge_faces(open)) {
      if (faces != 1) continue;
      std::array<Vec3, 2> at{open.positions[edge.first], open.positions[edge.second]};
      if (std::lexicographical_compare(at[1].begin(), at[1].end(), at[0].begin(), at[0].end()))
        std::swap(at[0], at[1]);
      ends.insert({at[0].x(), at[0].y(), at[0].z(), at[1].x(), at[1].y(), at[1].z()});
    }
    return ends;
  };
  const auto before = border_of(mesh);
  REQUIRE(before.size() > 20);
  RemeshOptions options = with_features(0.08, 0.17);
  options.keep_border = true;
  remesh(mesh, options);
  CHECK(border_of(mesh) == before);
  CHECK(is_oriented_manifold(mesh));
  CHECK(surface_area(mesh) == doctest::Approx(20).epsilon(1e-12));
  CHECK(SharpEdges(mesh, 40).length == doctest::Approx(18).epsilon(1e-12));
}
