/// Winding numbers in front of the corners of faces, compared with sums of solid angles.
#include "clean/exterior/region_growing_winding.h"

#include <doctest/doctest.h>

#include "clean/intersect/find_meetings.h"
#include "helpers/arrangement_facts.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

/// Returns the winding number in front of a point of a face.
int winding_in_front(const Mesh& mesh, const Triangle& t, const Vec3& p) {
  const Vec3 normal = normal_of(t[0], t[1], t[2]).normalized();
  const double w = test::winding_number(mesh, p + 1e-9 * normal);
  REQUIRE(std::abs(w - std::round(w)) < 1e-4);
  return static_cast<int>(std::lround(w));
}

struct Grown {
  explicit Grown(const Mesh& mesh) : welded(weld(mesh)) {}
  WeldedMesh welded;
  std::vector<Meeting> meetings = find_meetings(welded, Progress());
  Planes planes{welded, meetings};
  WindingJumps jumps{welded, planes};
  RegionGrowingWinding windings{welded, planes, jumps};
};

}  // namespace

TEST_CASE("w in front of corners agrees with solid angles") {
  std::size_t compared = 0, cut = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const Mesh mesh = test::random_balls(seed, 5);
    const Grown grown(mesh);
    const auto& [welded, meetings, planes, jumps, windings] = grown;
    CHECK(windings.rays() <= 5);
    for (Index f = 0; f < welded.faces.size(); ++f) {
      for (Index i = 0; i < 3; ++i) {
        const std::optional<int> found = windings.at(f, i);
        REQUIRE(found.has_value());  // the mesh is in general position
        const Triangle t = welded.triangle(f);
        const Vec3 middle = (t[0] + t[1] + t[2]) / 3;
        REQUIRE(*found == winding_in_front(mesh, t, t[i] + 1e-5 * (middle - t[i])));
        ++compared;
        cut += planes.is_whole(f) ? 0 : 1;
      }
    }
  }
  CHECK(compared > 3000);
  CHECK(cut > 1000);
}

TEST_CASE("a hidden face has no exterior part, and most interior faces are found") {
  std::size_t hidden = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Mesh mesh = test::random_balls(seed, 9);
    const Grown grown(mesh);
    const auto& [welded, meetings, planes, jumps, windings] = grown;
    test::Random random(seed);
    for (std::size_t plane = 0; plane < planes.size(); ++plane) {
      if (!windings.is_hidden(planes[plane], 1)) continue;
      ++hidden;
      const Triangle t = welded.triangle(planes[plane].faces[0]);
      for (int sample = 0; sample < 8; ++sample) {
        const double u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
        const Vec3 p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
        const int front = winding_in_front(mesh, t, p);
        REQUIRE((front < 1) == (front + 1 < 1));
      }
    }
  }
  CHECK(hidden > 300);
}

TEST_CASE("corners on other faces are left undecided") {
  // The second tetrahedron has a corner on a face of the first one.
  const Mesh first = test::tetrahedron();
  const Mesh mesh = test::joined(first, test::moved(first, {0.25, 0.25, 0}));
  const Grown grown(mesh);
  const auto& [welded, meetings, planes, jumps, windings] = grown;
  for (Index f = 0; f < welded.faces.size(); ++f)
    if (planes.is_whole(f)) CHECK(windings.at(f, 0) == windings.at(f, 1));
  std::size_t unknown = 0;
  for (Index f = 0; f < welded.faces.size(); ++f)
    for (Index i = 0; i < 3; ++i) unknown += windings.at(f, i) ? 0 : 1;
  CHECK(unknown > 0);
}
