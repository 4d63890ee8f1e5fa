#include "tm/clean/orient.h"

#include <algorithm>
#include <string>

#include "tm/mesh/edges.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

bool runs_up(const std::vector<Face>& faces, Index h) {
  return faces[h / 3][h % 3] < faces[h / 3][(h % 3 + 1) % 3];
}

struct Neighbors {
  std::vector<Index> across;  ///< per halfedge: the only other one of its edge, or no_index
  bool has_border = false;
};

Neighbors find_neighbors(const std::vector<Face>& faces, std::size_t points) {
  const Edges edges(faces, points);
  Neighbors result{std::vector<Index>(3 * faces.size(), no_index), false};
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    if (halfedges.size() != 2) continue;
    result.across[halfedges[0]] = halfedges[1];
    result.across[halfedges[1]] = halfedges[0];
  }
  return result;
}

double signed_volume(const std::vector<Face>& faces, const std::vector<Index>& component,
                     const std::vector<Vec3>& points, const std::vector<char>& turned) {
  const Vec3& origin = points[faces[component.front()][0]];
  double sum = 0;
  for (const Index f : component) {
    const Vec3 a = points[faces[f][0]] - origin, b = points[faces[f][1]] - origin;
    const double part = a.cross(b).dot(points[faces[f][2]] - origin);
    sum += turned[f] ? -part : part;
  }
  return sum;
}

// Visits the faces connected with the first; decides for each whether it must turn relative to it.
std::vector<Index> spread(const std::vector<Face>& faces, const Neighbors& neighbors, Index first,
                          std::vector<char>& visited, std::vector<char>& turned) {
  std::vector<Index> component{first};
  visited[first] = 1;
  for (std::size_t i = 0; i < component.size(); ++i) {
    const Index face = component[i];
    for (Index k = 0; k < 3; ++k) {
      const Index h = 3 * face + k;
      const Index across = neighbors.across[h];
      if (across == no_index) continue;
      const bool agree = runs_up(faces, h) != runs_up(faces, across);
      const char turn = agree ? turned[face] : !turned[face];
      if (!visited[across / 3]) {
        visited[across / 3] = 1;
        turned[across / 3] = turn;
        component.push_back(across / 3);
      } else if (turned[across / 3] != turn) {
        throw InputError("face " + std::to_string(across / 3) +
                         " can be oriented neither way: the surface has one side only, like a "
                         "Moebius strip; cut it open or remove that part");
      }
    }
  }
  return component;
}

bool is_closed(const Neighbors& neighbors, const std::vector<Index>& component) {
  return std::all_of(component.begin(), component.end(), [&](Index f) {
    return neighbors.across[3 * f] != no_index && neighbors.across[3 * f + 1] != no_index &&
           neighbors.across[3 * f + 2] != no_index;
  });
}

}  // namespace

std::size_t orient_faces(std::vector<Face>& faces, const std::vector<Vec3>& points) {
  const Neighbors neighbors = find_neighbors(faces, points.size());
  std::vector<char> visited(faces.size(), 0);
  std::vector<char> turned(faces.size(), 0);
  for (Index first = 0; first < faces.size(); ++first) {
    if (visited[first]) continue;
    const std::vector<Index> component = spread(faces, neighbors, first, visited, turned);
    const auto turns = static_cast<std::size_t>(
        std::count_if(component.begin(), component.end(), [&](Index f) { return turned[f] != 0; }));
    if (turns == 0) continue;
    const bool reverse = is_closed(neighbors, component)
                             ? signed_volume(faces, component, points, turned) < 0
                             : 2 * turns > component.size();
    for (const Index f : component) turned[f] = turned[f] != static_cast<char>(reverse);
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (turned[f]) std::swap(faces[f][1], faces[f][2]);
  }
  return static_cast<std::size_t>(std::count(turned.begin(), turned.end(), 1));
}

}  // namespace transformesh
