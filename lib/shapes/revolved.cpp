#include "shapes/revolved.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/elementary/trigonometric.h"

namespace transformesh::shapes {
namespace {

using std::numbers::pi;

/// Vertices on a circle around the axis, at equal angles; a single vertex if the radius is 0.
struct Ring {
  double radius, height;
  std::size_t count;
};

Ring ring_of(double radius, double height, double edge) {
  const double count = radius > 0 ? std::max(3.0, std::round(2 * pi * radius / edge)) : 1;
  return {radius, height, static_cast<std::size_t>(count)};
}

/// Appends the rings along a line of the profile, from the last ring to the given point.
void add_line(std::vector<Ring>& rings, double radius, double height, double edge) {
  const Ring from = rings.back();
  const double across = radius - from.radius, up = height - from.height;
  const auto steps = std::max(1L, std::lround(std::sqrt(across * across + up * up) / edge));
  for (long i = 1; i <= steps; ++i) {
    // The last ring has exactly the given radius and height. Hence flat ends stay flat, and tips
    // lie on the axis.
    const double share = static_cast<double>(i) / static_cast<double>(steps);
    rings.push_back(i == steps
                        ? ring_of(radius, height, edge)
                        : ring_of(from.radius + share * across, from.height + share * up, edge));
  }
}

/// Radius and height of each point, from the lowest.
using Profile = std::vector<std::pair<double, double>>;

std::vector<Ring> rings_of(const Profile& profile, double edge) {
  std::vector<Ring> rings{ring_of(profile[0].first, profile[0].second, edge)};
  for (std::size_t i = 1; i < profile.size(); ++i)
    add_line(rings, profile[i].first, profile[i].second, edge);
  return rings;
}

std::size_t count_faces(const std::vector<Ring>& rings) {
  std::size_t faces = 0;
  for (std::size_t i = 1; i < rings.size(); ++i)
    for (const Ring& ring : {rings[i - 1], rings[i]}) faces += ring.count > 1 ? ring.count : 0;
  return faces;
}

void add_vertices(Mesh& mesh, const Ring& ring) {
  for (std::size_t i = 0; i < ring.count; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(ring.count);
    mesh.positions.emplace_back(ring.radius * elementary::cos(angle),
                                ring.radius * elementary::sin(angle), ring.height);
  }
}

/// Adds triangles between two rings, in order of angle. Both rings are convex polygons around the
/// axis, and no chord of one polygon reaches the other polygon. Therefore no triangle is reversed
/// in the projection along the axis.
void add_faces(Mesh& mesh, Index first, std::size_t low, Index second, std::size_t high) {
  std::size_t i = 0, j = 0;
  const auto at = [](Index start, std::size_t k, std::size_t count) {
    return start + static_cast<Index>(k % count);
  };
  const std::size_t low_steps = low > 1 ? low : 0, high_steps = high > 1 ? high : 0;
  while (i < low_steps || j < high_steps) {
    const Index a = at(first, i, low), b = at(second, j, high);
    // Advance on the ring whose next vertex has the smaller angle, (i + 1) / low or (j + 1) / high
    // of a turn.
    const bool is_low = j == high_steps || (i < low_steps && (i + 1) * high <= (j + 1) * low);
    if (is_low) {
      mesh.faces.push_back({a, at(first, ++i, low), b});
    } else {
      mesh.faces.push_back({a, at(second, ++j, high), b});
    }
  }
}

Mesh mesh_of(const std::vector<Ring>& rings) {
  Mesh mesh;
  add_vertices(mesh, rings[0]);
  Index start = 0;
  for (std::size_t i = 1; i < rings.size(); ++i) {
    const auto next = static_cast<Index>(mesh.positions.size());
    add_vertices(mesh, rings[i]);
    add_faces(mesh, start, rings[i - 1].count, next, rings[i].count);
    start = next;
  }
  return mesh;
}

Mesh revolve(const Profile& profile, double size, std::size_t faces) {
  // The number of faces decreases with the edge length; 60 halvings exhaust the bits of a double.
  double small = 0, large = 4 * size;
  for (int halving = 0; halving < 60; ++halving) {
    const double edge = (small + large) / 2;
    // A lower bound of the number of faces avoids making too many rings. The profile has a line of
    // length `size`, and each of its rings adds at least three faces.
    const bool is_too_small = size / edge > static_cast<double>(faces);
    (is_too_small || count_faces(rings_of(profile, edge)) > faces ? small : large) = edge;
  }
  const std::vector<Ring> more = rings_of(profile, small > 0 ? small : large);
  const std::vector<Ring> less = rings_of(profile, large);
  const auto wanted = static_cast<double>(faces);
  const bool is_more_closer = static_cast<double>(count_faces(more)) / wanted <
                              wanted / static_cast<double>(count_faces(less));
  return mesh_of(is_more_closer ? more : less);
}

}  // namespace

Mesh cylinder(double radius, double height, std::size_t faces) {
  const double h = height / 2;
  return revolve({{0, -h}, {radius, -h}, {radius, h}, {0, h}}, std::max(radius, height), faces);
}

Mesh cone(double radius, double height, std::size_t faces) {
  const double h = height / 2;
  return revolve({{0, -h}, {radius, -h}, {0, h}}, std::max(radius, height), faces);
}

}  // namespace transformesh::shapes
