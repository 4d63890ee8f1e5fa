#include <doctest/doctest.h>

#include <algorithm>

#include "geometry/search/closest_point.h"
#include "helpers/mesh_facts.h"
#include "helpers/shape_options.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

using Genera = std::vector<long>;

// Returns one of 40 frames.
Mesh frame(int number, std::size_t faces) {
  return make_shape(shape("figure", faces, {std::to_string(number / 39.0)}));
}

double largest_distance(const Mesh& from, const Mesh& to) {
  const ClosestPointQuery closest(to);
  double largest = 0;
  for (const Vec3& point : from.positions) largest = std::max(largest, closest(point).distance);
  return largest;
}

}  // namespace

TEST_CASE("the arms are joined at the times that the manual says, and nothing crosses") {
  for (const char* time : {"0", "0.1", "0.243", "0.732", "0.9", "1"}) {
    CAPTURE(time);
    const Mesh mesh = make_shape(shape("figure", 4000, {time}));
    CHECK(count(mesh).genera == Genera{0});
    CHECK(crossings(mesh).pairs == 0);
  }
  for (const char* time : {"0.245", "0.3", "0.4", "0.5", "0.6", "0.730"}) {
    CAPTURE(time);
    const Mesh mesh = make_shape(shape("figure", 4000, {time}));
    CHECK(count(mesh).genera == Genera{1});
    CHECK(crossings(mesh).pairs == 0);
  }
}

TEST_CASE("the figure stands, and is within the cube of all shapes") {
  for (const char* time : {"0", "0.5", "1"}) {
    CAPTURE(time);
    const Box box = bounding_box(make_shape(shape("figure", 4000, {time})));
    CHECK(box.min().y() == doctest::Approx(-1.15).epsilon(0.02));
    CHECK(box.max().y() == doctest::Approx(1.02).epsilon(0.02));
    CHECK(box.min().minCoeff() > -1.2);
    CHECK(box.max().maxCoeff() < 1.2);
  }
}

TEST_CASE("consecutive frames of 40 are close, also when arms join and separate") {
  constexpr std::size_t faces = 10000;
  for (const int first : {9, 28, 30}) {
    CAPTURE(first);
    const Mesh before = frame(first, faces);
    const Mesh after = frame(first + 1, faces);
    const double most = (first == 30 ? 2 : 2.5) * mean_edge(before);
    CHECK(largest_distance(before, after) < most);
    CHECK(largest_distance(after, before) < most);
    CHECK(largest_distance(after, before) > mean_edge(before));
  }
}

TEST_CASE("the left arm crosses before the right one") {
  // The ends of the crossed forearms, beyond the middle.
  const Mesh mesh = make_shape(shape("figure", 4000, {"0.5"}));
  const auto foremost = [&](double side) {
    double z = 0;
    for (const Vec3& point : mesh.positions)
      if (side * point.x() > 0.05 && side * point.x() < 0.1) z = std::max(z, point.z());
    return z;
  };
  CHECK(foremost(-1) > foremost(1) + 0.05);
}

TEST_CASE("a time is a number from 0 to 1") {
  for (const char* time : {"-0.1", "1.1", "nan", "half", "0.5x", ""}) {
    CAPTURE(time);
    CHECK_THROWS_WITH_AS(make_shape(shape("figure", 4000, {time})),
                         doctest::Contains("is not a number from 0 to 1"), UsageError);
  }
}
