/// Random faces at a vertex that planes separate from a triangle, tested for contact.
#include "remesh/guards/star_planes.h"

#include <doctest/doctest.h>

#include "geometry/search/simplex_links.h"
#include "helpers/random.h"
#include "remesh/guards/triangle_contact.h"

using namespace transformesh;

namespace {

bool separates(const Vec3& vertex, const Triangle& triangle, const Triangle& face) {
  return StarPlanes(vertex, triangle).separate(arc_box(vertex, face[1], face[2]));
}

}  // namespace

TEST_CASE("faces that are separated from a triangle do not touch it") {
  test::Random random(2);
  for (const bool has_corner : {false, true}) {
    int separated = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec3 vertex = random.point(-1, 1);
      Triangle triangle{random.point(-1, 1), random.point(-1, 1), random.point(-1, 1)};
      if (has_corner) triangle[static_cast<std::size_t>(i) % 3] = vertex;
      const Vec3 rim = random.point(-1, 1);
      const Triangle face{vertex, rim, rim + random.point(-0.1, 0.1)};
      if (!separates(vertex, triangle, face)) continue;
      ++separated;
      CHECK_FALSE(may_touch(triangle, face));
    }
    CHECK(separated > 1000);
  }
}

TEST_CASE("neighbors around a vertex are separated, overlapping triangles are not") {
  const Vec3 top(0, 0, 1), a(1, 0, 0), b(0.9, 0.1, 0), c(0.8, 0.2, 0), d(0.7, 0.3, 0);
  CHECK(separates(top, {top, a, b}, {top, c, d}));
  CHECK(separates(top, {c, top, d}, {top, a, b}));
  CHECK_FALSE(separates(top, {top, a, c}, {top, b, c}));
  CHECK_FALSE(separates(top, {a, c, {0.9, 0.1, 0.5}}, {top, b, c}));
}

TEST_CASE("a triangle near the vertex has no planes, unless the vertex is its corner") {
  const Vec3 vertex(0.2, 0.2, 1e-10), a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  CHECK_FALSE(separates(vertex, {a, b, c}, {vertex, {0.2, 0.2, 1}, {0.2, 0.3, 1}}));
}
