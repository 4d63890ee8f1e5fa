#include "clean/intersect/any_intersection.h"

#include <doctest/doctest.h>

#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "transformesh/intersect.h"

using namespace transformesh;

TEST_CASE("the early search agrees with the full search") {
  for (const char* kind : {"two-spheres", "folded", "tangle", "boxes", "pinch", "torus"}) {
    for (const std::size_t faces : {800, 30000}) {
      if (faces > 800 && (kind == std::string("boxes") || kind == std::string("pinch"))) continue;
      CAPTURE(kind);
      CAPTURE(faces);
      const Mesh mesh = test::workload(kind, faces);
      CHECK(has_intersections(mesh) == !find_intersections(mesh).empty());
    }
  }
}

// One face intersects another, far from most samples; or all faces are in the same place.
TEST_CASE("a single crossing of a large mesh is found") {
  Mesh mesh = test::workload("torus", 30000);
  REQUIRE(!has_intersections(mesh));
  const auto& [a, b, c] = mesh.faces[12345];
  const Vec3 middle = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
  const Vec3 out = (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - middle);
  const auto first = static_cast<Index>(mesh.positions.size());
  const double length = (mesh.positions[b] - mesh.positions[a]).norm() / 100;
  for (const Vec3& move : {Vec3(out.normalized() * length), Vec3(-out.normalized() * length),
                           Vec3((mesh.positions[b] - mesh.positions[a]) / 100)})
    mesh.positions.push_back(middle + move);
  mesh.faces.push_back({first, first + 1, first + 2});
  CHECK(find_intersections(mesh).size() == 1);
  CHECK(has_intersections(mesh));

  for (Vec3& position : mesh.positions) position.setZero();
  CHECK(!has_intersections(mesh));
  mesh.positions[0] = Vec3::Constant(1e308);
  mesh.positions[1] = -mesh.positions[0];
  CHECK(!has_intersections(mesh));
}

TEST_CASE("sampled faces that do not intersect are no intersection, whatever the number of faces") {
  const Mesh torus = test::workload("torus", 6000);
  REQUIRE(torus.faces.size() > 5000);
  for (std::size_t faces = 4090; faces < 5000; faces += 7) {
    Mesh part = torus;
    part.faces.resize(faces);
    CAPTURE(faces);
    CHECK(!has_intersections(part));
  }
}
