/// Parts of random curves in a triangle, compared with winding numbers at points beside them.
#include "clean/exterior/bounding_subsegments.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "helpers/random.h"

using namespace transformesh;

namespace {

constexpr double size = 10;
constexpr int in_corner = 2;  ///< winding number in front of the face at its first corner

/// Curves in the triangle with corners (0, 0), (10, 0) and (0, 10).
class Curves {
 public:
  explicit Curves(std::uint64_t seed) : random_(seed) {
    in.face = 0;
    in.projection = {0, 1};
  }

  void add_polygon(const Vec3& center, double radius, int corners, int jump) {
    const auto first = static_cast<Index>(in.points.size());
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::acos(-1) * i / corners, r = radius * random_.uniform(0.6, 1);
      add_point(center + r * Vec3(std::cos(angle), std::sin(angle), 0), no_index);
    }
    for (Index i = 0; i < static_cast<Index>(corners); ++i) {
      const Index from = first + i, to = first + (i + 1) % static_cast<Index>(corners);
      // Segments may have either direction.
      if (random_.below(2) == 0)
        add_segment(from, to, jump);
      else
        add_segment(to, from, -jump);
    }
  }
  /// Adds a curve from the first edge of the triangle to the last edge.
  void add_chord(double x, double y, int jump) {
    const auto first = static_cast<Index>(in.points.size());
    add_point({x, 0, 0}, 0);
    add_point({0, y, 0}, 2);
    add_segment(first, first + 1, jump);
  }

  /// Returns the winding number in front of a point, by counting intersections with the curves on
  /// the way from the corner.
  int winding(const Vec3& p) const {
    const auto turn = [](const Vec3& a, const Vec3& b, const Vec3& c) {
      return (b - a).cross(c - a).z();
    };
    int w = in_corner;
    for (const PlanarSegment& s : in.segments) {
      const Vec3 &a = in.points[s.from].center, &b = in.points[s.to].center;
      const Vec3 origin(1e-9, 1e-9, 0);
      if (turn(origin, p, a) * turn(origin, p, b) > 0) continue;
      if (turn(a, b, origin) * turn(a, b, p) > 0) continue;
      w += turn(a, b, origin) > 0 ? s.jump : -s.jump;
    }
    return w;
  }

  std::optional<std::vector<Subsegment>> parts(int winding_level) const {
    const std::vector<Vec3> positions{{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
    const std::vector<Face> faces{{0, 1, 2}};
    const ExactGeometry geometry(positions, faces);
    return find_bounding_subsegments(geometry, in, {{geometry.given(0), in_corner, 0}},
                                     winding_level);
  }

  SegmentsInFace in;

 private:
  void add_point(const Vec3& p, Index edge) {
    in.points.push_back(ExactGeometry::free(p));
    in.edge_of.push_back(edge);
  }
  void add_segment(Index from, Index to, int jump) { in.segments.push_back({from, to, 0, jump}); }

  test::Random random_;
};

/// Returns the parameter of the intersection with another segment along this one; `end` for
/// no_index.
double share(const SegmentsInFace& in, Index s, Index other, double end) {
  if (other == no_index) return end;
  const Vec3 &a = in.points[in.segments[s].from].center, &b = in.points[in.segments[s].to].center;
  const Vec3& c = in.points[in.segments[other].from].center;
  const Vec3 along = in.points[in.segments[other].to].center - c;
  const double from = along.cross(a - c).z(), to = along.cross(b - c).z();
  return from / (from - to);
}

/// Compares all parts, and returns their number.
std::size_t compare(const Curves& curves, int winding_level) {
  const auto parts = curves.parts(winding_level);
  REQUIRE(parts.has_value());
  for (Index s = 0; s < curves.in.segments.size(); ++s) {
    const Vec3& from = curves.in.points[curves.in.segments[s].from].center;
    const Vec3 along = curves.in.points[curves.in.segments[s].to].center - from;
    const Vec3 left = Vec3(-along.y(), along.x(), 0).normalized() * 1e-7;
    for (double at = 0.0123; at < 1; at += 0.0371) {
      const Vec3 p = from + at * along;
      const bool is_left = curves.winding(p + left) == winding_level - 1;
      const bool is_right = curves.winding(p - left) == winding_level - 1;
      const auto part = std::find_if(parts->begin(), parts->end(), [&](const Subsegment& each) {
        return each.segment == s && share(curves.in, s, each.from, 0) < at &&
               at < share(curves.in, s, each.to, 1);
      });
      REQUIRE((part != parts->end()) == (is_left != is_right));
      if (part != parts->end()) REQUIRE(part->is_left == is_left);
    }
  }
  return parts->size();
}

}  // namespace

TEST_CASE("bounding subsegments have the exterior on one side") {
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    test::Random random(seed + 1000);
    Curves curves(seed);
    for (std::uint64_t i = 0; i < 2 + seed % 9; ++i) {
      const Vec3 center(random.uniform(1, 4), random.uniform(1, 4), 0);
      curves.add_polygon(center, random.uniform(0.3, 0.9), 3 + static_cast<int>(random.below(9)),
                         random.below(2) == 0 ? 1 : -1);
    }
    for (std::uint64_t i = 0; i < seed % 5; ++i)
      curves.add_chord(random.uniform(1, 9), random.uniform(1, 9), random.below(2) == 0 ? 1 : -1);
    for (const int winding_level : {0, 1, 2, 3, 4}) count += compare(curves, winding_level);
  }
  CHECK(count > 2000);
}

TEST_CASE("touching segments, and three through one point, are left undecided") {
  const auto chords = [](std::initializer_list<std::array<double, 2>> ends) {
    Curves curves(1);
    for (const auto& [x, y] : ends) curves.add_chord(x, y, 1);
    return curves.parts(1).has_value();
  };
  CHECK(chords({{2, 4}, {4, 2}}));
  CHECK_FALSE(chords({{2, 4}, {2, 5}}));  // two points at one position on an edge
  // The last edge of the polygon is missing, so that the curve has an end inside of the face.
  Curves curves(2);
  curves.add_polygon({3, 3, 0}, 1, 5, 1);
  curves.in.segments.pop_back();
  CHECK_FALSE(curves.parts(1).has_value());
}

TEST_CASE("without a known or consistent winding number nothing is decided") {
  Curves curves(3);
  curves.add_polygon({3, 3, 0}, 1, 5, 1);
  const std::vector<Vec3> positions{{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
  const std::vector<Face> faces{{0, 1, 2}};
  CHECK_FALSE(find_bounding_subsegments({positions, faces}, curves.in, {}, 1).has_value());
  // The jump across one side of the polygon contradicts the jumps across its other sides.
  curves.in.segments[2].jump *= -1;
  CHECK_FALSE(curves.parts(1).has_value());
}
