// torus-flow MAJOR MINOR TIME OUTPUT
//
// Writes the exact shape of a torus that moves by mean curvature, as a mesh. Its profile comes from
// the one-dimensional solver of the tests, which shares no code with the library.
#include <numbers>

#include "driver.h"
#include "helpers/revolution_flow.h"
#include "mesh_file.h"

using namespace transformesh;

namespace {

/// Points of the profile. Errors are proportional to the square of the spacing. With half as many
/// points, the volume at 0.4 of the time of collapse changes by less than 2e-5 of itself.
constexpr int profile_points = 400;
constexpr int turns = 1200;

Vec3 turned(const test::ProfilePoint& p, int turn) {
  const double angle = 2 * std::numbers::pi * turn / turns;
  return {p.x() * std::cos(angle), p.x() * std::sin(angle), p.y()};
}

Mesh revolved(const std::vector<test::ProfilePoint>& profile) {
  const auto count = static_cast<Index>(profile.size());
  const Index vertices = count * turns;
  Mesh mesh;
  for (int turn = 0; turn < turns; ++turn)
    for (const test::ProfilePoint& point : profile) mesh.positions.push_back(turned(point, turn));
  for (Index v = 0; v < vertices; ++v) {
    const Index up = v - v % count + (v + 1) % count;
    const Index next = (v + count) % vertices, next_up = (up + count) % vertices;
    mesh.faces.push_back({v, next, next_up});
    mesh.faces.push_back({v, next_up, up});
  }
  return mesh;
}

void make(double major, double minor, double time, const std::string& output) {
  test::RevolutionFlow flow(test::torus_profile(major, minor, profile_points));
  flow.advance_to(time);
  write_file(output, revolved(flow.points()));
}

}  // namespace

int main(int argc, char** argv) {
  return drive({argv, static_cast<std::size_t>(argc)}, "torus-flow MAJOR MINOR TIME OUTPUT",
               [](const auto& words) {
                 make(std::stod(words[0]), std::stod(words[1]), std::stod(words[2]), words[3]);
               });
}
