// revolution-flow torus|dumbbell|ellipsoid A B TIME OUTPUT
//
// Writes the exact shape of a surface of revolution that moves by mean curvature, as a mesh. Its
// profile comes from the one-dimensional solver of the tests, which shares no code with the
// library. A and B are the radii of the torus, or the radius and half of the height of the
// ellipsoid. A is the radius of the dumbbell's neck; B is not used.
#include "helpers/revolution_flow.h"

#include <array>
#include <numbers>

#include "driver.h"
#include "mesh_file.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

/// Number of points of the profile curve. Errors are proportional to the square of their spacing.
/// With half as many points, the relative change of the volumes of torus and dumbbell is below
/// 1e-4.
constexpr int profile_points = 401;
constexpr int turns = 1200;

test::Profile profile_of(const std::string& kind, double a, double b) {
  if (kind == "torus") return test::torus_profile(a, b, profile_points);
  if (kind == "dumbbell") return test::dumbbell_profile(a, profile_points);
  if (kind == "ellipsoid") return test::ellipsoid_profile(a, b, profile_points);
  throw UsageError("there is no kind '" + kind + "'");
}

Vec3 turned(const test::ProfilePoint& p, int turn) {
  const double angle = 2 * std::numbers::pi * turn / turns;
  return {p.x() * std::cos(angle), p.x() * std::sin(angle), p.y()};
}

/// Returns the surface of a profile. Points on the axis become one vertex each.
Mesh revolved(const test::Profile& profile) {
  const std::vector<test::ProfilePoint>& points = profile.points;
  Mesh mesh;
  std::vector<std::array<Index, turns>> vertices(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_pole = !profile.is_closed && (i == 0 || i + 1 == points.size());
    for (int turn = 0; turn < turns; ++turn) {
      if (turn == 0 || !is_pole) mesh.positions.push_back(turned(points[i], turn));
      vertices[i][turn] = static_cast<Index>(mesh.positions.size() - 1);
    }
  }
  const auto add = [&](Index a, Index b, Index c) {
    if (a != b && b != c && c != a) mesh.faces.push_back({a, b, c});
  };
  for (std::size_t i = profile.is_closed ? 0 : 1; i < points.size(); ++i) {
    const auto &low = vertices[(i + points.size() - 1) % points.size()], &high = vertices[i];
    for (int turn = 0; turn < turns; ++turn) {
      const int next = (turn + 1) % turns;
      add(low[turn], low[next], high[next]);
      add(low[turn], high[next], high[turn]);
    }
  }
  return mesh;
}

void make(const std::string& kind, double a, double b, double time, const std::string& output) {
  test::Profile profile = profile_of(kind, a, b);
  test::RevolutionFlow flow(profile);
  flow.advance_to(time);
  profile.points = flow.points();
  write_file(output, revolved(profile));
}

}  // namespace

int main(int argc, char** argv) {
  return drive({argv, static_cast<std::size_t>(argc)},
               "revolution-flow torus|dumbbell|ellipsoid A B TIME OUTPUT", [](const auto& words) {
                 make(words[0], std::stod(words[1]), std::stod(words[2]), std::stod(words[3]),
                      words[4]);
               });
}
