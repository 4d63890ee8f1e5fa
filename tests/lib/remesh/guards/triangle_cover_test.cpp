/// Triangles near a few faces, for which the answer can be derived by hand.
#include "remesh/guards/triangle_cover.h"

#include <doctest/doctest.h>

#include "helpers/random.h"
#include "helpers/sampled_distance.h"
#include "remesh/guards/near_faces.h"

using namespace transformesh;

namespace {

struct Answer {
  bool is_covered;
  std::size_t cuts;
  std::size_t used;
};

Answer cover(const std::vector<Triangle>& faces, const Triangle& triangle, double distance,
             std::size_t most_cuts = 100) {
  std::vector<NearCandidate> candidates;
  for (const Triangle& face : faces)
    candidates.push_back({static_cast<Index>(candidates.size()), NearTriangle(face)});
  NearCandidates surface(candidates, distance * distance);
  TriangleCover<NearCandidates> cover(surface, most_cuts);
  const bool is_covered =
      cover.covers({CoverCorner{triangle[0]}, CoverCorner{triangle[1]}, CoverCorner{triangle[2]}});
  return {is_covered, most_cuts - cover.cuts_left(), surface.used().size()};
}

const Triangle lower{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)};
const Triangle upper{Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};

}  // namespace

TEST_CASE("a triangle over one face needs no cut") {
  const Triangle triangle{Vec3(0.3, 0.1, 0.1), Vec3(0.9, 0.2, -0.1), Vec3(0.9, 0.7, 0)};
  const Answer answer = cover({upper, lower}, triangle, 0.1001);
  CHECK(answer.is_covered);
  CHECK(answer.cuts == 0);
  CHECK(answer.used == 1);
  CHECK_FALSE(cover({upper, lower}, triangle, 0.0999).is_covered);
}

TEST_CASE("a triangle over the edge of two faces is cut there, however small the distance is") {
  const Triangle triangle{Vec3(0.2, 0.7, 0), Vec3(0.6, 0.1, 0), Vec3(0.9, 0.3, 0)};
  for (const double distance : {1e-3, 1e-6, 1e-12}) {
    const Answer answer = cover({upper, lower}, triangle, distance);
    CHECK(answer.is_covered);
    CHECK(answer.cuts <= 4);
    CHECK(answer.used == 2);
  }
  CHECK_FALSE(cover({upper, lower}, triangle, 1e-12, 0).is_covered);
}

TEST_CASE("a triangle over a gap is covered if its half is within the distance, with some room") {
  Triangle apart = upper;
  for (Vec3& p : apart) p += Vec3(-0.1, 0.1, 0);  // makes a gap whose half is 0.0707
  const Triangle triangle{Vec3(0.2, 0.7, 0), Vec3(0.6, 0.1, 0), Vec3(0.9, 0.3, 0)};
  CHECK(cover({apart, lower}, triangle, 0.08).is_covered);
  CHECK_FALSE(cover({apart, lower}, triangle, 0.0705).is_covered);
  CHECK_FALSE(cover({}, triangle, 9).is_covered);
}

TEST_CASE("distances of triangles are those of another formula") {
  test::Random random(5);
  for (int i = 0; i < 20000; ++i) {
    Triangle triangle;
    for (Vec3& p : triangle) p = random.point(-1, 1);
    if (i % 4 == 1) triangle[2] = triangle[0] + 1e-3 * (triangle[2] - triangle[0]);
    if (i % 4 == 2) triangle[2] = triangle[1];
    if (i % 400 == 3) triangle[1] = triangle[2] = triangle[0];
    const Vec3 point = random.point(-2, 2);
    CHECK(NearTriangle(triangle).squared_distance(point) ==
          doctest::Approx(test::squared_to_triangle(point, triangle)).epsilon(1e-9));
  }
}
