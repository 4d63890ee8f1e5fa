// Finds where two spheres intersect and checks that the segments lie near the common circle.
#include <transformesh/intersect.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  Mesh mesh = make_sphere(Vec3(-0.5, 0, 0), 1, 1000);
  if (!find_intersections(mesh).empty()) return 1;
  const Mesh second = make_sphere(Vec3(0.5, 0, 0), 1, 1000);
  const auto first_vertex = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), second.positions.begin(), second.positions.end());
  for (const Face& f : second.faces)
    mesh.faces.push_back({f[0] + first_vertex, f[1] + first_vertex, f[2] + first_vertex});
  const std::vector<FacePair> pairs = find_intersections(mesh);
  if (pairs.empty() || pairs[0].first >= pairs[0].second) return 1;
  const auto segments = intersection_segments(mesh, pairs);
  if (segments.size() != pairs.size()) return 1;
  for (const auto& [start, end] : segments) {
    if (std::abs(start.x()) > 0.03 || std::abs(end.x()) > 0.03) return 1;
    if (std::abs(std::hypot(start.y(), start.z()) - std::sqrt(0.75)) > 0.03) return 1;
  }
  return 0;
}
