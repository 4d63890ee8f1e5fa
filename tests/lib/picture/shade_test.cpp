#include "picture/shade.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/shapes.h"
#include "picture/lights.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

const Mesh centered_cube = cuboid({-1, -1, -1}, {1, 1, 1});

Camera front_camera(int size = 65) {
  return orbit_camera({Vec3::Zero(), 8}, {0, 0, Axis::y, 1}, size, size);
}

Mesh with_column(Mesh mesh, bool of_faces, const std::string& name, Scalar type,
                 std::vector<double> values) {
  Columns& columns = of_faces ? mesh.face_columns : mesh.vertex_columns;
  columns.get(name, type, values.size()).values = std::move(values);
  return mesh;
}

Mesh painted(Mesh mesh, bool of_faces, const std::array<double, 3>& color, Scalar type) {
  const std::size_t rows = of_faces ? mesh.faces.size() : mesh.positions.size();
  const std::array<const char*, 3> names{"red", "green", "blue"};
  for (std::size_t i = 0; i < 3; ++i)
    mesh = with_column(mesh, of_faces, names[i], type, std::vector<double>(rows, color[i]));
  return mesh;
}

Pixel center(const Mesh& mesh, const ShadeOptions& options = {}) {
  return shade(mesh, front_camera(), options).at(32, 32);
}

}  // namespace

TEST_CASE("the middle of a cube's front has the light of its plane, the corner the background") {
  ShadeOptions options;
  options.color.front = color_of_srgb(0.6, 0.4, 0.2);
  options.background.top = Color(0, 1, 0);
  options.background.bottom = Color(0, 1, 0);
  const Image image = shade(centered_cube, front_camera(), options);
  const Lights lights(front_camera(), Vec3::UnitY());
  const Color lit = lights.reflected(*options.color.front, {0, 0, 1}, {0, 0, 1});
  for (int i = 0; i < 3; ++i) {
    const int expected = srgb_byte(lit[i]);
    CHECK(std::abs(image.at(32, 32)[static_cast<std::size_t>(i)] - expected) <= 1);
  }
  CHECK(image.at(0, 0) == Pixel{0, 255, 0, 255});
  CHECK(image.at(64, 64) == Pixel{0, 255, 0, 255});
}

TEST_CASE("light comes from the upper left, and the sky is above") {
  const Lights lights(front_camera(), Vec3::UnitY());
  const auto light = [&](float x, float y, float z) {
    return lights.reflected(Color::Ones(), Eigen::Vector3f(x, y, z).normalized(), {0, 0, 1}).sum();
  };
  CHECK(light(-1, 0, 1) > light(1, 0, 1));
  CHECK(light(0, 1, 1) > light(0, -1, 1));
  CHECK(light(0, -1, 0) > 0);
}

TEST_CASE("colors come from the option, then from vertices, then from faces") {
  const std::array<double, 3> green{0, 255, 0};
  const std::array<double, 3> blue{0, 0, 1};
  const Mesh vertices = painted(centered_cube, false, green, Scalar::uint8);
  const Mesh both = painted(vertices, true, blue, Scalar::float32);
  const Mesh faces = painted(centered_cube, true, blue, Scalar::float32);
  ShadeOptions red;
  red.color.front = Color(1, 0, 0);
  const auto strongest = [](const Pixel& pixel) {
    return std::max_element(pixel.begin(), pixel.begin() + 3) - pixel.begin();
  };
  CHECK(strongest(center(vertices)) == 1);
  CHECK(strongest(center(both)) == 1);
  CHECK(strongest(center(faces)) == 2);
  CHECK(strongest(center(both, red)) == 0);

  ShadeOptions plain;
  plain.color.front = Color(0, 1, 0);
  CHECK(center(vertices) == center(centered_cube, plain));
}

TEST_CASE("vertex colors blend across a face") {
  Mesh sheet = moved(scaled(grid(1), 2), {-1, -1, 0});
  for (const char* name : {"red", "green", "blue"}) {
    std::vector<double> values;
    for (const Vec3& point : sheet.positions) values.push_back(point.x() > 0 ? 255 : 0);
    sheet = with_column(sheet, false, name, Scalar::uint8, values);
  }
  const Image image = shade(sheet, front_camera());
  for (int x = 20; x < 44; ++x) CHECK(image.at(x, 32)[0] < image.at(x + 1, 32)[0]);
}

TEST_CASE("back sides are dark red") {
  const Pixel front = center(centered_cube);
  const Pixel back = center(reversed(centered_cube));
  CHECK(front[2] > front[0]);
  CHECK(back[0] > back[2] + 30);
  CHECK(back[0] > back[1] + 30);
}

TEST_CASE("highlighted faces and vertices are orange, and the rest is as without") {
  std::vector<double> marks(12, 0);
  marks[2] = 3;  // the front is faces 2 and 3
  const Mesh marked = with_column(centered_cube, true, "intersections", Scalar::int32, marks);
  ShadeOptions options;
  options.color.highlight = "intersections";
  const Image image = shade(marked, front_camera(), options);
  const Image plain = shade(marked, front_camera());
  const auto is_orange = [](const Pixel& p) { return p[0] > p[1] + 30 && p[1] > p[2] + 30; };
  int orange = 0;
  int unchanged = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    orange += is_orange(image.pixels[i]);
    unchanged += image.pixels[i] == plain.pixels[i];
  }
  CHECK(orange > 100);
  CHECK(unchanged > 100);
  CHECK(orange + unchanged > 65 * 65 - 200);

  const Mesh vertices =
      with_column(centered_cube, false, "moved", Scalar::uint8, std::vector<double>(8, 1));
  options.color.highlight = "moved";
  CHECK(is_orange(center(vertices, options)));
  options.color.highlight = "absent";
  CHECK_THROWS_AS(shade(marked, front_camera(), options), UsageError);
}

TEST_CASE("the surface is colored by numbers of faces, else of vertices, interpolated") {
  ShadeOptions options;
  options.color.by = "h";
  options.color.scale = {0, 1};
  const auto by_vertices = [](double value) {
    return with_column(centered_cube, false, "h", Scalar::float64, std::vector<double>(8, value));
  };
  const auto by_faces = [](double value) {
    return with_column(centered_cube, true, "h", Scalar::float32, std::vector<double>(12, value));
  };
  for (const double value : {0.0, 0.3, 1.0})
    CHECK(center(by_vertices(value), options) == center(by_faces(value), options));
  CHECK(center(by_faces(0), options) != center(by_faces(1), options));

  // If left corners are 0 and right corners 1, the middle has the value in between.
  const Mesh slope =
      with_column(centered_cube, false, "h", Scalar::float64, {0, 1, 0, 1, 0, 1, 0, 1});
  CHECK(center(slope, options) == center(by_faces(0.5), options));
  const Pixel gray = center(by_vertices(NAN), options);
  CHECK(std::max({gray[0], gray[1], gray[2]}) - std::min({gray[0], gray[1], gray[2]}) < 30);
  options.color.by = "absent";
  CHECK_THROWS_AS(shade(slope, front_camera(), options), UsageError);
}

TEST_CASE("segments on the surface show, those behind it do not") {
  // The front of the cube is at z = 1; a line is two pixels wide.
  const auto lines_at = [](double z) {
    ShadeOptions options;
    options.segments = {{Vec3(-0.8, 0, z), Vec3(0.8, 0, z)}};
    const Image image = shade(centered_cube, front_camera(), options);
    const Image plain = shade(centered_cube, front_camera());
    int changed = 0;
    for (int y = 0; y < image.height; ++y) changed += image.at(32, y) != plain.at(32, y);
    return changed;
  };
  CHECK(lines_at(1) >= 2);
  CHECK(lines_at(1) <= 4);
  CHECK(lines_at(1.5) >= 2);
  CHECK(lines_at(0) == 0);
  CHECK(lines_at(100) == 0);  // behind the eye
}

TEST_CASE("edges are dark lines about a pixel wide") {
  ShadeOptions options;
  options.draw_edges = true;
  const Image plain = shade(centered_cube, front_camera(200));
  const Image lined = shade(centered_cube, front_camera(200), options);
  // The diagonal of the front crosses every row once; the sides are outside.
  for (int y = 80; y < 120; y += 5) {
    int darker = 0;
    for (int x = 70; x < 130; ++x) darker += lined.at(x, y)[1] + 20 < plain.at(x, y)[1];
    CHECK(darker >= 1);
    CHECK(darker <= 3);
  }
}

TEST_CASE("outlines are smooth: some pixels are partly covered") {
  ShadeOptions options;
  options.background.is_transparent = true;
  const Image image = shade(icosphere(4), front_camera(), options);
  long coverage = 0;
  int partial = 0;
  for (const Pixel& pixel : image.pixels) {
    coverage += pixel[3];
    partial += pixel[3] > 0 && pixel[3] < 255;
  }
  CHECK(partial > 30);
  CHECK(image.at(0, 0) == Pixel{0, 0, 0, 0});
  CHECK(image.at(32, 32)[3] == 255);
  // The disc of a unit sphere at distance 8; the focal length maps 30 degrees to 65 pixels.
  const double focal = 32.5 / std::tan(15 * 3.14159265358979323846 / 180);
  const double area = 3.14159265358979323846 * focal * focal / (8.0 * 8 - 1);
  CHECK(static_cast<double>(coverage) / 255 == doctest::Approx(area).epsilon(0.01));

  options.samples = 1;
  const Image jagged = shade(icosphere(4), front_camera(), options);
  for (const Pixel& pixel : jagged.pixels) CHECK((pixel[3] == 0 || pixel[3] == 255));
}

TEST_CASE("meshes without faces or with degenerate faces only show the background") {
  Mesh flat;
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.faces = {{0, 1, 2}, {1, 1, 1}};
  CHECK(shade(flat, front_camera()).pixels == shade(Mesh{}, front_camera()).pixels);
}

TEST_CASE("the same bytes for any number of threads") {
  const Image all = shade(icosphere(4), front_camera());
  const ThreadLimit one(1);
  CHECK(shade(icosphere(4), front_camera()).pixels == all.pixels);
}

TEST_CASE("a part of an image is what the picture would be, and the rest stays") {
  const Image alone = shade(centered_cube, front_camera());
  const Pixel other{1, 2, 3, 4};
  Image whole(80, 70, other);
  shade(centered_cube, front_camera(), {}, 10, 3, whole);
  for (int y = 0; y < whole.height; ++y)
    for (int x = 0; x < whole.width; ++x) {
      const bool is_inside = x >= 10 && x < 75 && y >= 3 && y < 68;
      REQUIRE(whole.at(x, y) == (is_inside ? alone.at(x - 10, y - 3) : other));
    }
}
