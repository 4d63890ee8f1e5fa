#include "picture/panels.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

std::vector<Panel> panels_of(const std::vector<const Mesh*>& meshes, const PictureOptions& options,
                             int strip = 0) {
  return lay_out(meshes, options, strip);
}

/// Returns the height of the image of a mesh in its panel, in pixels.
double height_in(const Panel& panel) {
  double low = 1e9, high = -1e9;
  for (const Vec3& position : panel.mesh->positions) {
    const Vec3 q = panel.camera.project(position);
    low = std::min(low, q.y() / q.z());
    high = std::max(high, q.y() / q.z());
  }
  return high - low;
}

}  // namespace

TEST_CASE("panels side by side fill the picture without overlap, above the strip") {
  const Mesh mesh = test::cube();
  PictureOptions options;
  options.width = 301;
  options.height = 100;
  const std::vector<Panel> panels = panels_of({&mesh, &mesh, &mesh}, options, 20);
  REQUIRE(panels.size() == 3);
  int x = 0;
  for (const Panel& panel : panels) {
    CHECK(panel.x == x);
    CHECK(panel.y == 0);
    CHECK(panel.camera.height == 80);
    x += panel.camera.width;
  }
  CHECK(x == 301);
}

TEST_CASE("columns break rows, and the whole of each mesh is in its panel") {
  const Mesh small = test::scaled(test::icosphere(1), .5), large = test::icosphere(1);
  PictureOptions options;
  options.columns = 2;
  const std::vector<Panel> panels = panels_of({&small, &large, &small}, options);
  REQUIRE(panels.size() == 3);
  CHECK(panels[2].x == 0);
  CHECK(panels[2].y == panels[0].camera.height);
  for (const Panel& panel : panels)
    for (const Vec3& position : panel.mesh->positions) {
      const Vec3 q = panel.camera.project(position);
      REQUIRE(q.z() > 0);
      CHECK(q.x() / q.z() > -.5);
      CHECK(q.x() / q.z() < panel.camera.width - .5);
      CHECK(q.y() / q.z() > -.5);
      CHECK(q.y() / q.z() < panel.camera.height - .5);
    }
}

TEST_CASE("framing by scale shows a mesh of half the size half as large") {
  const Mesh small = test::scaled(test::icosphere(2), .5), large = test::icosphere(2);
  PictureOptions options;
  options.framing = Framing::each;
  std::vector<Panel> panels = panels_of({&small, &large}, options);
  CHECK(height_in(panels[0]) == doctest::Approx(height_in(panels[1])));
  options.framing = Framing::scale;
  panels = panels_of({&small, &large}, options);
  // In perspective the nearer surface of the large ball appears slightly larger.
  CHECK(height_in(panels[1]) / height_in(panels[0]) == doctest::Approx(2).epsilon(.1));
}

TEST_CASE("a mesh without faces and a picture without room for panels are refused") {
  const Mesh mesh = test::cube(), points{mesh.positions, {}, {}, {}};
  CHECK_THROWS_AS(panels_of({&points}, {}), InputError);
  PictureOptions narrow;
  narrow.width = 2;
  narrow.columns = 3;
  CHECK_THROWS_AS(panels_of({&mesh, &mesh, &mesh}, narrow), UsageError);
}
