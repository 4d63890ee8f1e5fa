#include "picture/picture.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "picture/legend.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

const Mesh ball = icosphere(3);
const Mesh small_ball = scaled(icosphere(3), 0.5);
const Mesh far_ball = moved(icosphere(3), {2, 0, 0});

PictureOptions silhouettes(int width, int height, Framing framing = Framing::each) {
  PictureOptions options;
  options.width = width;
  options.height = height;
  options.framing = framing;
  options.orbit = {0, 0, Axis::y, 1};
  options.shade.background.is_transparent = true;
  return options;
}

Image draw(std::vector<const Mesh*> meshes, const PictureOptions& options) {
  return draw_picture(meshes, options);
}

/// Counts the covered pixels in columns [first, last).
double covered(const Image& image, int first, int last) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = first; x < last; ++x) sum += image.at(x, y)[3] / 255.0;
  return sum;
}

}  // namespace

TEST_CASE("each mesh fills its panel, whatever its size") {
  const Image image = draw({&ball, &small_ball}, silhouettes(240, 120));
  CHECK(covered(image, 0, 120) > 8000);
  CHECK(covered(image, 0, 120) == doctest::Approx(covered(image, 120, 240)).epsilon(0.001));
  const Image alone = draw({&ball}, silhouettes(120, 120));
  CHECK(covered(alone, 0, 120) == covered(image, 0, 120));
}

TEST_CASE("the same scale keeps sizes comparable") {
  const Image image = draw({&ball, &small_ball}, silhouettes(240, 120, Framing::scale));
  const double ratio = covered(image, 0, 120) / covered(image, 120, 240);
  // squared sines of the tangent cones, at the distance at which the large ball fits
  CHECK(ratio > 4);
  CHECK(ratio < 4.5);
}

TEST_CASE("the same place keeps positions comparable") {
  const Image image = draw({&ball, &far_ball}, silhouettes(400, 200, Framing::place));
  CHECK(covered(image, 0, 100) > 10 * covered(image, 100, 200));
  CHECK(covered(image, 300, 400) > 10 * covered(image, 200, 300));
}

TEST_CASE("a movie keeps still around another mesh") {
  PictureOptions options = silhouettes(120, 120);
  options.around = &ball;
  const double whole = covered(draw({&ball}, options), 0, 120);
  const double half = covered(draw({&small_ball}, options), 0, 120);
  CHECK(whole / half > 4);
}

TEST_CASE("zoom enlarges") {
  PictureOptions options = silhouettes(120, 120);
  const double before = covered(draw({&ball}, options), 0, 120);
  options.orbit.zoom = 0.5;
  CHECK(covered(draw({&ball}, options), 0, 120) == doctest::Approx(before / 4).epsilon(0.01));
}

TEST_CASE("panels fill rows, then columns, without a gap for any size") {
  PictureOptions options = silhouettes(101, 67);
  options.columns = 2;
  const Image image = draw({&ball, &ball, &ball}, options);
  const auto alpha = [&](int x, int y) { return int{image.at(x, y)[3]}; };
  CHECK(alpha(25, 16) == 255);
  CHECK(alpha(75, 16) == 255);
  CHECK(alpha(25, 50) == 255);
  CHECK(alpha(75, 50) == 0);
}

TEST_CASE("views go around: each is the first of a turn that begins there") {
  const Mesh ring = torus(1, 0.3, 24, 12);
  PictureOptions options = silhouettes(240, 60);
  options.orbit = {10, 20, Axis::x, 1};
  options.views = 4;
  options.columns = 4;
  const Image image = draw({&ring}, options);
  for (int view = 1; view < 4; ++view) {
    options.orbit.azimuth_deg = 10 + 90 * view;
    const Image turned = draw({&ring}, options);
    int different = 0;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 60; ++x) different += image.at(60 * view + x, y) != turned.at(x, y);
    CHECK(different == 0);
    CHECK(covered(turned, 0, 60) > 500);
  }
}

TEST_CASE("frames of a movie are views of the same distance") {
  const Mesh box = cuboid({0, 0, 0}, {1, 2, 3});
  PictureOptions options = silhouettes(120, 60);
  options.views = 2;
  const Image both = draw({&box}, options);
  options.width = 60;
  options.views = 1;
  options.frames = 2;
  for (options.frame = 0; options.frame < 2; ++options.frame)
    CHECK(covered(draw({&box}, options), 0, 60) ==
          covered(both, 60 * options.frame, 60 * options.frame + 60));
}

TEST_CASE("views of one mesh have the largest panels, of several a row each") {
  PictureOptions options = silhouettes(300, 200);
  options.views = 6;
  const Image one = draw({&ball}, options);  // 3 columns and 2 rows
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 3; ++column)
      CHECK(one.at(50 + 100 * column, 50 + 100 * row)[3] == 255);
  CHECK(one.at(100, 50)[3] == 0);
  options.views = 3;
  const Image two = draw({&ball, &small_ball}, options);
  CHECK(two.at(50, 50) == two.at(50, 150));
  CHECK(two.at(100, 50)[3] == 0);
}

TEST_CASE("highlights need one mesh that has the property") {
  Mesh marked = ball;
  marked.face_columns.get("intersections", Scalar::int32, marked.faces.size()).values[0] = 1;
  PictureOptions options = silhouettes(60, 30);
  options.shade.color.highlight = "intersections";
  CHECK_NOTHROW(draw({&ball, &marked}, options));
  CHECK_THROWS_AS(draw({&ball, &ball}, options), UsageError);
}

TEST_CASE("colors stand for the same numbers in every panel, and the legend is below") {
  const auto valued = [](double value) {
    Mesh mesh = ball;
    Column& column = mesh.face_columns.get("h", Scalar::float64, mesh.faces.size());
    std::fill(column.values.begin(), column.values.end(), value);
    return mesh;
  };
  const Mesh low = valued(1);
  const Mesh high = valued(3);
  PictureOptions options = silhouettes(240, 120);
  options.shade.color.by = "h";
  const auto middle = [](const Image& image, int panel) { return image.at(60 + 120 * panel, 52); };
  const Image both = draw({&low, &high}, options);
  CHECK(middle(both, 0)[2] > middle(both, 0)[1]);      // the color is purple
  CHECK(middle(both, 1)[1] > 2 * middle(both, 1)[2]);  // the color is yellow
  CHECK(both.at(120, 119 - legend_height(240, 120) / 2)[3] == 255);
  options.range = {3, 5};
  CHECK(middle(draw({&low, &high}, options), 1) == middle(both, 0));
  options.range = {3, 3};
  CHECK_THROWS_AS(draw({&low, &high}, options), UsageError);
  options.range.reset();
  CHECK_NOTHROW(draw({&low, &ball}, options));
  CHECK_THROWS_AS(draw({&ball, &ball}, options), UsageError);
}

TEST_CASE("what cannot be drawn is refused in words") {
  const Mesh empty;
  CHECK_THROWS_AS(draw({}, {}), InputError);
  CHECK_THROWS_WITH_AS(draw({&ball, &empty}, {}), "mesh 2 has no faces to draw", InputError);
  CHECK_THROWS_AS(draw({&ball}, silhouettes(0, 10)), UsageError);
  CHECK_THROWS_AS(draw({&ball}, silhouettes(40000, 10)), UsageError);
  CHECK_THROWS_AS(draw({&ball}, silhouettes(30000, 30000)), UsageError);
  CHECK_THROWS_AS(draw({&ball, &ball}, silhouettes(1, 1)), UsageError);
}

TEST_CASE("drawing can be cancelled") {
  const std::vector<const Mesh*> meshes{&ball};
  const Progress stop([](std::string_view, double) { return false; });
  CHECK_THROWS_AS(draw_picture(meshes, silhouettes(20, 20), stop), CancelledError);
}
