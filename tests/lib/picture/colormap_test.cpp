#include "picture/colormap.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "helpers/shapes.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

std::vector<int> bytes(const Color& color) {
  return {srgb_byte(color[0]), srgb_byte(color[1]), srgb_byte(color[2])};
}

/// Returns CIE lightness, which a perceptually uniform map increases evenly.
double lightness(const Color& color) {
  return 116 * std::cbrt(0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2]) - 16;
}

Mesh with_values(bool of_faces, const std::string& name, std::vector<double> values) {
  Mesh mesh = cube();
  Columns& columns = of_faces ? mesh.face_columns : mesh.vertex_columns;
  columns.get(name, Scalar::float64, values.size()).values = std::move(values);
  return mesh;
}

}  // namespace

TEST_CASE("ends and middle have the published colors, and values beyond those of the ends") {
  const ColorScale scale{2, 4};
  CHECK(bytes(scale.at(2)) == std::vector<int>{68, 1, 84});
  CHECK(bytes(scale.at(4)) == std::vector<int>{253, 231, 37});
  CHECK(scale.at(-1e300) == scale.at(2));
  CHECK(scale.at(1e300) == scale.at(4));
  // the published middle is between 33,145,140 and 32,146,140
  const std::vector<int> middle = bytes(scale.at(3));
  CHECK(std::abs(middle[0] - 33) <= 1);
  CHECK(std::abs(middle[1] - 145) <= 1);
  CHECK(std::abs(middle[2] - 140) <= 1);
}

TEST_CASE("lightness rises evenly from one end to the other") {
  const ColorScale scale{0, 1};
  for (int i = 0; i <= 20; ++i) {
    const double even =
        lightness(scale.at(0)) + i / 20.0 * (lightness(scale.at(1)) - lightness(scale.at(0)));
    CHECK(std::abs(lightness(scale.at(i / 20.0)) - even) < 3);
  }
}

TEST_CASE("if both signs occur, 0 is white, blue below and red above, symmetrically") {
  const ColorScale scale{-1, 4};
  CHECK(scale.is_diverging());
  CHECK(bytes(scale.at(0)) == std::vector<int>{247, 247, 247});
  CHECK(bytes(scale.at(4)) == std::vector<int>{103, 0, 31});
  const std::vector<int> below = bytes(scale.at(-1));
  CHECK(below[2] > below[0]);
  CHECK(lightness(scale.at(-1)) > lightness(scale.at(4)) + 30);
  CHECK_FALSE(ColorScale{0, 1}.is_diverging());
}

TEST_CASE("values that are no numbers are gray; any finite ends are allowed") {
  const ColorScale scale{0, 1};
  for (const double value : {no_number, infinity, -infinity})
    CHECK(bytes(scale.at(value)) == std::vector<int>{128, 128, 128});
  const double most = std::numeric_limits<double>::max();
  CHECK(bytes(ColorScale{-most, most}.at(0)) == std::vector<int>{247, 247, 247});
  CHECK(bytes(ColorScale{5, 5}.at(5)) == bytes(ColorScale{0, 1}.at(0.5)));
}

TEST_CASE("a scale spans the finite values of all meshes") {
  const Mesh a = with_values(false, "h", {no_number, 3, infinity, 4, 5, 3, 3, 3});
  const Mesh b = with_values(true, "h", {1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, -infinity});
  const Mesh c = cube();
  const std::vector<const Mesh*> meshes{&a, &b, &c};
  const ColorScale scale = scale_of_column(meshes, "h");
  CHECK(scale.low == 1);
  CHECK(scale.high == 5);
  CHECK_THROWS_WITH_AS(scale_of_column(meshes, "absent"),
                       "neither faces nor vertices have a property 'absent' of numbers to color "
                       "by; faces have h, vertices h",
                       UsageError);
  const Mesh none = with_values(false, "h", std::vector<double>(8, no_number));
  const std::vector<const Mesh*> only{&none};
  CHECK(scale_of_column(only, "h").high == 1);
}
