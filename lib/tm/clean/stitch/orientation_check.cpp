#include "tm/clean/stitch/orientation_check.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <span>

#include "tm/clean/stitch/orient.h"
#include "tm/mesh/edges.h"
#include "tm/mesh/location_text.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

constexpr std::size_t most_named = 5;

// With the faces without area, which the soup lacks: so they make no border. Those that name a
// point twice run both ways along their edge.
std::vector<Face> all_faces(const Soup& soup, const Mesh& mesh, const std::vector<char>& left_out) {
  std::vector<Face> faces;
  faces.reserve(mesh.faces.size());
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    if (!left_out.empty() && left_out[i]) continue;
    const Face& f = mesh.faces[i];
    faces.push_back({soup.point_of[f[0]], soup.point_of[f[1]], soup.point_of[f[2]]});
  }
  return faces;
}

bool runs_up(std::span<const Face> faces, Index h) {
  return faces[h / 3][h % 3] < faces[h / 3][(h % 3 + 1) % 3];
}

// How many faces more run up than down.
int sum_along(std::span<const Face> faces, std::span<const Index> halfedges) {
  int sum = 0;
  for (const Index h : halfedges) sum += runs_up(faces, h) ? 1 : -1;
  return sum;
}

using BorderEdges = std::multimap<Index, Index>;  // from point to point, along the faces

// As many border edges leave every point as arrive, so every walk closes.
std::vector<std::vector<Index>> walk(BorderEdges border) {
  std::vector<std::vector<Index>> loops;
  while (!border.empty()) {
    std::vector<Index>& loop = loops.emplace_back();
    Index at = border.begin()->first;
    for (auto step = border.find(at); step != border.end(); step = border.find(at)) {
      loop.push_back(at);
      at = step->second;
      border.erase(step);
    }
  }
  return loops;
}

std::string list_text(const std::vector<Index>& faces) {
  std::string text = "faces " + std::to_string(faces[0]);
  const std::size_t named = std::min(faces.size(), most_named);
  for (std::size_t i = 1; i < named; ++i) {
    const bool is_last = i + 1 == faces.size();
    text += (is_last ? " and " : ", ") + std::to_string(faces[i]);
  }
  if (named < faces.size()) text += " and " + std::to_string(faces.size() - named) + " more";
  return text;
}

std::string edge_problem(const Mesh& mesh, std::span<const Index> halfedges, bool up) {
  std::vector<Index> alike;
  for (const Index h : halfedges) {
    if (runs_up(mesh.faces, h) == up) alike.push_back(h / 3);
  }
  const auto first = std::find_if(halfedges.begin(), halfedges.end(),
                                  [&](Index h) { return runs_up(mesh.faces, h) == up; });
  const std::size_t against = halfedges.size() - alike.size();
  return list_text(alike) + " run the same way along the " + edge_text(mesh, *first) +
         (against == 0 ? "" : ", and only " + std::to_string(against) + " the other way");
}

Mesh welded(const Soup& soup, const Mesh& mesh) {
  Mesh result{mesh.positions, mesh.faces, {}, {}};
  for (Face& face : result.faces) {
    for (Index& v : face) v = soup.vertex_of[soup.point_of[v]];
  }
  return result;
}

}  // namespace

Borders find_borders(const Soup& soup, const Mesh& mesh, const std::vector<char>& left_out) {
  const std::vector<Face> faces = all_faces(soup, mesh, left_out);
  const Edges edges(faces, soup.points.size());
  Borders borders;
  BorderEdges border;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    const int sum = sum_along(faces, halfedges);
    if (sum == 0) continue;
    if (std::abs(sum) > 1) borders.is_oriented = false;
    const Face& f = faces[halfedges[0] / 3];
    const auto [low, high] = std::minmax(f[halfedges[0] % 3], f[(halfedges[0] % 3 + 1) % 3]);
    for (int i = 0; i < std::abs(sum); ++i) {
      border.emplace(sum > 0 ? low : high, sum > 0 ? high : low);
    }
  }
  borders.loops = walk(std::move(border));
  return borders;
}

std::string describe_misorientation(const Mesh& mesh) {
  const Edges edges(without_collapsed(mesh.faces), mesh.positions.size());
  std::string text;
  std::size_t count = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const int sum = sum_along(mesh.faces, edges.halfedges(e));
    if (std::abs(sum) <= 1) continue;
    if (count == 0) text = edge_problem(mesh, edges.halfedges(e), sum > 0);
    ++count;
  }
  if (count > 1) text += " (the first of " + std::to_string(count) + " such edges)";
  return text;
}

bool can_be_oriented(const Soup& soup, const Mesh& mesh) {
  Mesh turned = welded(soup, mesh);
  try {
    orient_faces(turned);
  } catch (const InputError&) {
    return false;
  }
  return describe_misorientation(turned).empty();
}

void refuse_orientation(const Soup& soup, const Mesh& mesh) {
  Mesh turned = welded(soup, mesh);
  const std::string problem = describe_misorientation(turned);
  orient_faces(turned);
  const std::string rest = describe_misorientation(turned);
  if (rest.empty()) {
    throw InputError(problem + ": the mesh is not oriented; mend it with tm-stitch --orient");
  }
  throw InputError(rest +
                   ", and turning sheets (tm-stitch --orient) cannot change that: remove "
                   "faces there");
}

}  // namespace transformesh
