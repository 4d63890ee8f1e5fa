#include "raster/rasterize.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "support/parallel.h"
#include "transformesh/control.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// Returns a camera at the origin that looks along z.
Camera camera_at_origin(int width, int height, double focal) {
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.projection << focal, 0, 0.5 * (width - 1), 0,  //
      0, focal, 0.5 * (height - 1), 0,                  //
      0, 0, 1, 0;
  return camera;
}

std::size_t count_covered(const FaceBuffer& buffer) {
  std::size_t count = 0;
  for (const FacePixel& pixel : buffer.pixels) count += pixel.face != no_index;
  return count;
}

/// Returns the first face that a ray through the pixel hits, by Cramer's rule for each face.
FacePixel cast_ray(const Mesh& mesh, const Vec3& ray, double& margin) {
  FacePixel hit;
  double nearest = HUGE_VAL;
  margin = HUGE_VAL;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& [i, j, k] = mesh.faces[f];
    const Vec3& c = mesh.positions[k];
    Eigen::Matrix3d system;
    system << c - mesh.positions[i], c - mesh.positions[j], ray;
    const Vec3 solution = system.fullPivLu().solve(c);
    const double inside = std::min({solution[0], solution[1], 1 - solution[0] - solution[1]});
    if (solution[2] > 0) margin = std::min(margin, std::abs(inside));
    if (inside < 0 || solution[2] <= 0 || solution[2] >= nearest) continue;
    nearest = solution[2];
    hit = {static_cast<Index>(f),
           static_cast<float>(nearest),
           {static_cast<float>(solution[0]), static_cast<float>(solution[1])}};
  }
  return hit;
}

}  // namespace

TEST_CASE("a sphere covers the disc that geometry says, its pole at the right depth") {
  const Mesh ball = moved(icosphere(5), {0, 0, 5});
  const Camera camera = camera_at_origin(401, 401, 800);
  const FaceBuffer buffer = rasterize(ball, camera);
  // The sine of half the opening angle of the cone that touches the sphere is 1/5.
  const double radius = 800 / std::sqrt(5.0 * 5 - 1);
  const double area = std::numbers::pi * radius * radius;
  CHECK(std::abs(static_cast<double>(count_covered(buffer)) - area) < 0.003 * area);
  CHECK(std::abs(buffer.at(200, 200).depth - 4) < 1e-3);
  for (int angle = 0; angle < 360; angle += 15) {
    const double x = std::cos(angle * std::numbers::pi / 180);
    const double y = std::sin(angle * std::numbers::pi / 180);
    const auto at = [&](double r) {
      return buffer.at(static_cast<int>(std::lround(200 + r * x)),
                       static_cast<int>(std::lround(200 + r * y)));
    };
    CHECK(at(radius - 2).face != no_index);
    CHECK(at(radius + 2).face == no_index);
  }
}

TEST_CASE("every pixel sees what a ray through its center hits first, also beside the eye") {
  Random random(11);
  const Camera camera = camera_at_origin(48, 36, 30);
  Mesh soup;
  for (int f = 0; f < 40; ++f) {
    for (int i = 0; i < 3; ++i) soup.positions.push_back(random.point(-4, 6));
    const Index base = static_cast<Index>(3 * f);
    soup.faces.push_back({base, base + 1, base + 2});
  }
  const FaceBuffer buffer = rasterize(soup, camera);
  int compared = 0;
  for (int y = 0; y < buffer.height; ++y)
    for (int x = 0; x < buffer.width; ++x) {
      double margin = 0;
      const Vec3 ray((x - 23.5) / 30, (y - 17.5) / 30, 1);
      const FacePixel hit = cast_ray(soup, ray, margin);
      if (margin < 1e-9) continue;
      ++compared;
      const FacePixel& seen = buffer.at(x, y);
      REQUIRE(seen.face == hit.face);
      if (hit.face == no_index) continue;
      CHECK(seen.depth == doctest::Approx(hit.depth).epsilon(1e-5));
      CHECK(std::abs(seen.weight[0] - hit.weight[0]) < 1e-5);
      CHECK(std::abs(seen.weight[1] - hit.weight[1]) < 1e-5);
    }
  CHECK(compared > 48 * 36 * 9 / 10);
}

TEST_CASE("faces that share an edge leave no gap, whatever the view") {
  const Mesh sheet = scaled(moved(grid(40), {-0.5, -0.5, 0}), 30);
  for (const double azimuth : {0.0, 17.0, 45.0, 60.0}) {
    const Camera camera =
        orbit_camera({Vec3::Zero(), 6}, {azimuth, 0.5 * azimuth, Axis::y, 1}, 150, 150);
    CHECK(count_covered(rasterize(sheet, camera)) == 150 * 150);
  }
  // All vertices of this grid are exactly at pixel centers.
  Mesh aligned = grid(10);
  for (Vec3& point : aligned.positions) point = {10 * point.x() - 5, 10 * point.y() - 5, 1};
  CHECK(count_covered(rasterize(aligned, camera_at_origin(11, 11, 1))) == 121);
}

TEST_CASE("the mirrored mesh gives the mirrored buffer") {
  const Mesh ring = moved(torus(1, 0.4, 31, 17), {0.1, 0.2, 4});
  Mesh mirrored = reversed(ring);
  for (Vec3& point : mirrored.positions) point.x() = -point.x();
  const Camera camera = camera_at_origin(200, 100, 120);
  const FaceBuffer buffer = rasterize(ring, camera);
  const FaceBuffer other = rasterize(mirrored, camera);
  CHECK(count_covered(buffer) > 1000);
  int different = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 200; ++x) different += buffer.at(x, y).face != other.at(199 - x, y).face;
  CHECK(different == 0);
}

TEST_CASE("of coincident faces the first is drawn; degenerate and hidden ones are not") {
  Mesh mesh;
  mesh.positions = {{-1, -1, 2}, {1, -1, 2}, {0, 1, 2},     {0, 0, -3}, {1, 0, -3}, {0, 1, -3},
                    {-1, 0, 1},  {0, 0, 1},  {0.5, 0, 1.0}, {0, 1, 0},  {1, 0, 0}};
  mesh.faces = {{6, 7, 8}, {3, 4, 5}, {0, 0, 1}, {7, 9, 3}, {0, 1, 2}, {2, 1, 0}, {0, 1, 2}};
  const FaceBuffer buffer = rasterize(mesh, camera_at_origin(20, 20, 20));
  CHECK(count_covered(buffer) > 100);
  for (const FacePixel& pixel : buffer.pixels) CHECK((pixel.face == 4 || pixel.face == no_index));
}

TEST_CASE("huge, tiny and enclosing meshes are drawn or left out, and nothing breaks") {
  const Camera camera = camera_at_origin(30, 30, 30);
  CHECK(count_covered(rasterize(Mesh{}, camera)) == 0);
  CHECK(count_covered(rasterize(scaled(icosphere(2), 100), camera)) == 900);
  for (const double size : {1e-300, 1e-100, 1e100, 1e300})
    CHECK(count_covered(rasterize(scaled(moved(icosphere(1), {0, 0, 1.5}), size), camera)) <= 900);
}

TEST_CASE("the buffer is the same for any number of threads") {
  const Mesh ball = moved(icosphere(5), {0.3, 0.1, 3});
  const Camera camera = camera_at_origin(300, 200, 250);
  const FaceBuffer all = rasterize(ball, camera);
  const ThreadLimit one(1);
  const FaceBuffer single = rasterize(ball, camera);
  bool is_same = true;
  for (std::size_t i = 0; i < all.pixels.size(); ++i)
    is_same = is_same && all.pixels[i].face == single.pixels[i].face &&
              all.pixels[i].depth == single.pixels[i].depth &&
              all.pixels[i].weight == single.pixels[i].weight;
  CHECK(is_same);
}

TEST_CASE("the part of a picture in its box, drawn at once or by bands, equals the whole buffer") {
  // The ball extends below the picture.
  const Mesh ball = moved(icosphere(4), {0.3, 1.1, 3});
  const Camera camera = camera_at_origin(90, 61, 70);
  const FaceBuffer whole = rasterize(ball, camera, Sides::outside);
  for (const int rows : {16, 61}) {
    const BandRasterizer bands(ball, camera, rows, Sides::outside);
    const PixelBox& box = bands.box();
    CHECK(box.columns() < 90);
    FaceBuffer part(box.columns(), box.rows());
    for (std::size_t band = 0; band < bands.bands(); ++band)
      bands.draw(band, box, part.pixels.data());
    CHECK(count_covered(part) == count_covered(whole));
    int different = 0;
    for (int y = box.first_row; y < box.end_row; ++y)
      for (int x = box.first_column; x < box.end_column; ++x)
        different += part.at(x - box.first_column, y - box.first_row).face != whole.at(x, y).face;
    CHECK(different == 0);
  }
}

TEST_CASE("bands of any height are the rows of the whole buffer") {
  const Mesh ball = moved(icosphere(4), {0.3, 0.1, 2});
  const Camera camera = camera_at_origin(90, 61, 70);
  const FaceBuffer whole = rasterize(ball, camera);
  for (const int rows : {1, 7, 61, 100}) {
    const BandRasterizer bands(ball, camera, rows);
    REQUIRE(bands.bands() == static_cast<std::size_t>((61 + rows - 1) / rows));
    int different = 0;
    for (std::size_t band = 0; band < bands.bands(); ++band) {
      FaceBuffer part(90, rows);
      bands.draw(band, part.row(0));
      for (int y = 0; y < rows && static_cast<int>(band) * rows + y < 61; ++y)
        for (int x = 0; x < 90; ++x) {
          const FacePixel& seen = whole.at(x, static_cast<int>(band) * rows + y);
          different += part.at(x, y).face != seen.face || part.at(x, y).depth != seen.depth;
        }
    }
    CHECK(different == 0);
  }
}

TEST_CASE("the box of bands encloses the visible part tightly") {
  const Mesh ball = moved(icosphere(4), {0.3, 0.1, 4});
  const Camera camera = camera_at_origin(90, 61, 70);
  const FaceBuffer whole = rasterize(ball, camera);
  PixelBox seen{90, 0, 61, 0};
  for (int y = 0; y < 61; ++y) {
    for (int x = 0; x < 90; ++x) {
      if (whole.at(x, y).face == no_index) continue;
      seen = {std::min(seen.first_column, x), std::max(seen.end_column, x + 1),
              std::min(seen.first_row, y), std::max(seen.end_row, y + 1)};
    }
  }
  const PixelBox box = BandRasterizer(ball, camera, 16).box();
  CHECK(std::abs(box.columns() - seen.columns()) <= 2);
  CHECK(std::abs(box.rows() - seen.rows()) <= 2);
  CHECK(box.first_column <= seen.first_column);
  CHECK(box.end_column >= seen.end_column);
  CHECK(box.first_row <= seen.first_row);
  CHECK(box.end_row >= seen.end_row);
  const PixelBox none = BandRasterizer(moved(ball, {0, 0, -20}), camera, 16).box();
  CHECK(none.columns() == 0);
  CHECK(none.rows() == 0);
}
