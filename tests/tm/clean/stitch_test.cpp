#include "tm/clean/stitch.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "tm/mesh/components.h"
#include "tm/mesh/manifold.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

/// Every face with vertices of its own.
Mesh soup_of(const Mesh& mesh) {
  Mesh soup;
  for (const Face& face : mesh.faces) {
    const auto base = static_cast<Index>(soup.positions.size());
    for (const Index v : face) soup.positions.push_back(mesh.positions[v]);
    soup.faces.push_back({base, base + 1, base + 2});
  }
  return soup;
}

std::vector<double> volumes(const Mesh& mesh) {
  std::vector<double> result;
  for (const Component& c : connected_components(mesh).components) result.push_back(c.volume);
  return result;
}

bool is_closed_manifold(const Mesh& mesh) {
  const ManifoldReport report = check_manifold(mesh);
  return report.is_manifold() && report.is_oriented() && report.is_closed();
}

}  // namespace

TEST_CASE("a soup becomes the mesh it was cut from") {
  const Mesh torus = test::torus(1, 0.3, 20, 10);
  Mesh mesh = soup_of(torus);
  const StitchResult result = stitch(mesh);
  CHECK(mesh.positions.size() == torus.positions.size());
  CHECK(mesh.faces.size() == torus.faces.size());
  CHECK(result.joined_vertices == 3 * torus.faces.size() - torus.positions.size());
  CHECK(result.copied_vertices == 0);
  CHECK(is_closed_manifold(mesh));
}

TEST_CASE("singular vertex: cubes that touch in a corner come apart there") {
  Mesh mesh = soup_of(test::joined(test::cube(), test::moved(test::cube(), {1, 1, 1})));
  CHECK(stitch(mesh).copied_vertices == 1);
  CHECK(is_closed_manifold(mesh));
  CHECK(connected_components(mesh).components.size() == 2);
  for (const double v : volumes(mesh)) CHECK(v == doctest::Approx(1));
}

TEST_CASE("singular edge: cubes that touch along an edge pair across their insides") {
  Mesh mesh = soup_of(test::joined(test::cube(), test::moved(test::cube(), {1, 1, 0})));
  CHECK(stitch(mesh).copied_vertices == 2);
  CHECK(is_closed_manifold(mesh));
  CHECK(connected_components(mesh).components.size() == 2);
  for (const double v : volumes(mesh)) CHECK(v == doctest::Approx(1));
}

TEST_CASE("singular triangle: solids on both sides of a face keep one each") {
  const Mesh right = test::tetrahedron();
  Mesh left = right;
  for (Vec3& p : left.positions) p[0] = -p[0];
  left = test::reversed(left);
  Mesh mesh = soup_of(test::joined(right, left));
  CHECK(stitch(mesh).copied_vertices == 3);
  CHECK(is_closed_manifold(mesh));
  CHECK(connected_components(mesh).components.size() == 2);
  for (const double v : volumes(mesh)) CHECK(v == doctest::Approx(1.0 / 6));
}

TEST_CASE("orient turns faces until neighbours agree, and closed parts outwards") {
  Mesh mesh = test::joined(test::icosphere(2), test::moved(test::icosphere(1), {5, 0, 0}));
  for (std::size_t f = 0; f < mesh.faces.size(); f += 3) {
    std::swap(mesh.faces[f][0], mesh.faces[f][1]);
  }
  Mesh unturned = mesh;
  CHECK(stitch(unturned).misoriented_edges > 0);
  StitchOptions options;
  options.orient = true;
  const StitchResult result = stitch(mesh, options);
  CHECK(result.turned_faces > 0);
  CHECK(result.misoriented_edges == 0);
  CHECK(is_closed_manifold(mesh));
  for (const double v : volumes(mesh)) CHECK(v > 0);
}

TEST_CASE("a strip with one side is refused") {
  Mesh strip;
  constexpr Index n = 12;
  for (Index i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    for (const double s : {-0.2, 0.2}) {
      const double r = 1 + s * std::cos(a / 2);
      strip.positions.emplace_back(r * std::cos(a), r * std::sin(a), s * std::sin(a / 2));
    }
  }
  for (Index i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    const Index a = 2 * i, b = 2 * i + 1, c = last ? 1 : 2 * i + 2, d = last ? 0 : 2 * i + 3;
    strip.faces.push_back({a, c, b});
    strip.faces.push_back({b, c, d});
  }
  StitchOptions options;
  options.orient = true;
  CHECK_THROWS_AS(stitch(strip, options), InputError);
}

TEST_CASE("a tolerance joins what is close and nothing else") {
  Mesh mesh = soup_of(test::icosphere(2));
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.positions[v][v % 3] += 1e-7 * static_cast<double>(v % 5);
  }
  Mesh apart = mesh;
  CHECK(stitch(apart).border_edges > 0);
  StitchOptions options;
  options.tolerance = 1e-5;
  stitch(mesh, options);
  CHECK(mesh.positions.size() == test::icosphere(2).positions.size());
  CHECK(is_closed_manifold(mesh));
}

TEST_CASE("columns follow their vertices and faces") {
  Mesh mesh = soup_of(test::cube());
  Column& x = mesh.vertex_columns.get("x_copy", Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) x.values[v] = mesh.positions[v][0];
  mesh.face_columns.get("id", Scalar::int32, mesh.faces.size()).values[3] = 7;
  stitch(mesh);
  CHECK(mesh.vertex_columns.find("x_copy")->values.size() == 8);
  for (std::size_t v = 0; v < 8; ++v) {
    CHECK(mesh.vertex_columns.find("x_copy")->values[v] == mesh.positions[v][0]);
  }
  CHECK(mesh.face_columns.find("id")->values[3] == 7);
}

}  // namespace transformesh
