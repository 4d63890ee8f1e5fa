/// Meshes split along their intersections keep areas, volumes and columns.
#include "clean/arrange/refine.h"

#include <doctest/doctest.h>

#include "helpers/random.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "mesh/triangle.h"
#include "transformesh/measure.h"

using namespace transformesh;

TEST_CASE("refining splits what crosses and keeps volume, area and columns") {
  for (const char* kind : {"two-spheres", "folded", "tangle", "pinch"}) {
    CAPTURE(kind);
    const Mesh mesh = test::workload(kind, 1500);
    const Mesh refined = refine(mesh);
    // Rounding may make slivers intersect if hundreds of faces meet in one point.
    if (kind != std::string("pinch")) CHECK(find_intersections(refined).empty());
    CHECK(volume(refined) == doctest::Approx(volume(mesh)).epsilon(1e-12));
    CHECK(surface_area(refined) == doctest::Approx(surface_area(mesh)).epsilon(1e-12));
    const Column& source = *refined.face_columns.find("source_face");
    for (Index f = 0; f < refined.faces.size(); ++f) {
      const auto from = static_cast<Index>(source.values[f]);
      REQUIRE(face_normal(refined, f).dot(face_normal(mesh, from)) >= 0);
    }
  }
}

TEST_CASE("vertices keep their order and columns, and new ones interpolate a linear function") {
  const auto linear = [](const Vec3& p) { return 1 + 2 * p.x() - 3 * p.y() + p.z(); };
  Mesh mesh = test::joined(test::icosphere(2), test::moved(test::icosphere(2), {0.8, 0.1, 0.3}));
  Column& value = mesh.vertex_columns.get("value", Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    value.values[v] = linear(mesh.positions[v]);
  const Mesh refined = refine(mesh);
  REQUIRE(refined.positions.size() > mesh.positions.size());
  for (std::size_t v = 0; v < refined.positions.size(); ++v) {
    if (v < mesh.positions.size()) CHECK(refined.positions[v] == mesh.positions[v]);
    CHECK(refined.vertex_columns.find("value")->values[v] ==
          doctest::Approx(linear(refined.positions[v])).epsilon(1e-12));
  }
}

TEST_CASE("the row of a point on a face has its barycentric weights, which sum to 1 outside too") {
  test::Random random(1);
  for (int round = 0; round < 100; ++round) {
    Mesh mesh;
    for (int i = 0; i < 3; ++i) mesh.positions.push_back(random.point(-1, 1));
    mesh.faces = {{2, 0, 1}};
    const double u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
    const std::array<double, 3> weights{1 - u - v, u, v};
    const Triangle t = triangle_of(mesh, 0);
    const RowBlend row =
        row_on_face(mesh, 0, weights[0] * t[0] + weights[1] * t[1] + weights[2] * t[2]);
    CHECK(row.source == mesh.faces[0]);
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(row.weight[i] == doctest::Approx(weights[i]).epsilon(1e-6));

    const RowBlend outside = row_on_face(mesh, 0, random.point(-9, 9));
    CHECK(outside.weight[0] + outside.weight[1] + outside.weight[2] == doctest::Approx(1));
    for (const double weight : outside.weight) {
      CHECK(weight >= 0);
      CHECK(weight <= 1);
    }
  }
}
