#include "remesh/halfedges/vertex_role.h"

#include <numbers>

#include "remesh/halfedges/sharpness.h"
#include "support/elementary/trigonometric.h"

namespace transformesh {
namespace {

/// The cosine of 45 degrees. A vertex at which a line turns by more than 45 degrees is a corner.
constexpr double corner_cosine = 0.7071067811865476;

}  // namespace

void mark_features(EditableMesh& mesh, double feature_angle_deg) {
  mesh.clear_features();
  if (feature_angle_deg >= 180) return;
  const double cosine = elementary::cos(feature_angle_deg * std::numbers::pi / 180);
  const std::vector<Vec3> normals = steady_normals(mesh);
  for (Index h = 0; h < mesh.halfedge_slots(); ++h) {
    if (!mesh.is_edge(h) || mesh.is_border(h)) continue;
    const Vec3& here = normals[h / 3];
    const Vec3& there = normals[mesh.opposite(h) / 3];
    if (!here.isZero(0) && !there.isZero(0) && here.dot(there) < cosine) mesh.set_feature(h, true);
  }
}

std::array<Index, 2> VertexRoles::line_neighbors(Index vertex) const {
  std::array<Index, 2> result{no_index, no_index};
  mesh_.for_each_neighbor(vertex, [&](Index neighbor, Index halfedge) {
    if (is_line(mesh_, halfedge)) result[result[0] == no_index ? 0 : 1] = neighbor;
  });
  return result;
}

VertexRole VertexRoles::role(Index vertex) const {
  const bool on_border = mesh_.is_border_vertex(vertex);
  if (on_border && keep_border_) return VertexRole::fixed;
  if (!on_border && !mesh_.has_features()) return VertexRole::free;
  Index lines = 0;
  mesh_.for_each_neighbor(vertex,
                          [&](Index, Index halfedge) { lines += is_line(mesh_, halfedge); });
  if (lines == 0) return VertexRole::free;
  if (lines != 2) return VertexRole::fixed;
  const auto [before, after] = line_neighbors(vertex);
  const Vec3 in = mesh_.position(vertex) - mesh_.position(before);
  const Vec3 out = mesh_.position(after) - mesh_.position(vertex);
  const bool turns = in.dot(out) < corner_cosine * in.norm() * out.norm();
  return turns ? VertexRole::fixed : VertexRole::on_line;
}

bool VertexRoles::may_merge(Index halfedge) const {
  if (!has_lines_) return true;
  const VertexRole source = role(mesh_.source(halfedge));
  const VertexRole target = role(mesh_.target(halfedge));
  if (source == VertexRole::fixed && target == VertexRole::fixed) return false;
  if (source == VertexRole::free || target == VertexRole::free) return true;
  return is_line(mesh_, halfedge);
}

}  // namespace transformesh
