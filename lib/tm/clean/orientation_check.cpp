#include "tm/clean/orientation_check.h"

#include <algorithm>
#include <map>
#include <span>
#include <string>

#include "tm/mesh/edges.h"
#include "tm/support/error.h"
#include "tm/support/length.h"

namespace transformesh {
namespace {

// Faces without area are missing from the soup, and so do not make a border.
std::vector<Face> all_faces(const Soup& soup, const Mesh& mesh) {
  std::vector<Face> faces;
  faces.reserve(mesh.faces.size());
  for (const Face& f : mesh.faces) {
    faces.push_back({soup.point_of[f[0]], soup.point_of[f[1]], soup.point_of[f[2]]});
  }
  return faces;
}

[[noreturn]] void refuse(const Mesh& mesh, std::span<const Index> halfedges) {
  const Index a = halfedge_source(mesh, halfedges[0]);
  const Vec3& p = mesh.positions[a];
  throw InputError(
      "faces " + std::to_string(halfedges[0] / 3) + " and " + std::to_string(halfedges[1] / 3) +
      " run the same way along their common edge at vertex " + std::to_string(a) + " (" +
      shortest_text(p[0]) + " " + shortest_text(p[1]) + " " + shortest_text(p[2]) +
      "): the mesh is not oriented; mend it with tm-stitch "
      "--orient");
}

}  // namespace

std::vector<std::vector<Index>> find_border_loops(const Soup& soup, const Mesh& mesh) {
  const std::vector<Face> faces = all_faces(soup, mesh);
  const Edges edges(faces, soup.points.size());
  std::multimap<Index, Index> border;  // from point to point, along the faces
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    int forward = 0;
    const auto runs_up = [&](Index h) {
      return faces[h / 3][h % 3] < faces[h / 3][(h % 3 + 1) % 3];
    };
    for (const Index h : halfedges) forward += runs_up(h) ? 1 : -1;
    if (forward == 0) continue;
    if (forward < -1 || forward > 1) refuse(mesh, halfedges);
    // Where faces pair up around the edge but for one, that one ends there.
    const Index h = *std::find_if(halfedges.begin(), halfedges.end(),
                                  [&](Index k) { return runs_up(k) == (forward > 0); });
    border.emplace(faces[h / 3][h % 3], faces[h / 3][(h % 3 + 1) % 3]);
  }

  // As many border edges leave every point as arrive, so every walk closes.
  std::vector<std::vector<Index>> loops;
  while (!border.empty()) {
    std::vector<Index> loop;
    Index at = border.begin()->first;
    for (auto step = border.find(at); step != border.end(); step = border.find(at)) {
      loop.push_back(at);
      at = step->second;
      border.erase(step);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace transformesh
