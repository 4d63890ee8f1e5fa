#include "remesh/halfedges/editable_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <string>

#include "mesh/location_text.h"
#include "remesh/halfedges/halfedges.h"
#include "transformesh/errors.h"

namespace transformesh {

EditableMesh::EditableMesh(const Mesh& mesh) : EditableMesh(mesh, manifold_opposites(mesh)) {}

EditableMesh::EditableMesh(const Mesh& mesh, std::vector<Index> opposites)
    : positions_(mesh.positions),
      opposites_(std::move(opposites)),
      outgoing_(mesh.positions.size(), no_index),
      vertex_rows_(mesh.positions.size()),
      face_rows_(mesh.faces.size()),
      vertex_columns_(mesh.vertex_columns),
      face_columns_(mesh.face_columns),
      vertex_row_count_(static_cast<Index>(mesh.positions.size())) {
  sources_.reserve(3 * mesh.faces.size());
  for (const Face& face : mesh.faces) sources_.insert(sources_.end(), face.begin(), face.end());
  std::iota(vertex_rows_.begin(), vertex_rows_.end(), 0U);
  std::iota(face_rows_.begin(), face_rows_.end(), 0U);
  has_borders_ = std::find(opposites_.begin(), opposites_.end(), no_index) != opposites_.end();
  find_outgoing();
}

void EditableMesh::find_outgoing() {
  std::vector<Index> count(positions_.size(), 0);
  for (Index h = 0; h < halfedge_slots(); ++h) {
    ++count[source(h)];
    // Chooses the border halfedge if there is one, otherwise the lowest.
    if (outgoing_[source(h)] == no_index || is_border(h)) outgoing_[source(h)] = h;
  }
  isolated_.assign(positions_.size(), false);
  for (Index v = 0; v < vertex_slots(); ++v) {
    isolated_[v] = count[v] == 0;
    if (isolated_[v]) continue;
    Index reached = 0;
    for_each_outgoing(v, [&](Index) { ++reached; });
    if (reached == count[v]) continue;
    throw InputError(ErrorKind::not_manifold,
                     "vertex " + std::to_string(v) + " joins " + std::to_string(count[v]) +
                         " faces that do not form one umbrella (face " +
                         std::to_string(outgoing_[v] / 3) +
                         " is in one of them): the mesh is not an oriented manifold",
                     {.faces = {outgoing_[v] / 3},
                      .position = position_data(positions_[v]),
                      .counts = {count[v]}});
  }
}

std::vector<Index> EditableMesh::squeezed_vertices(std::vector<Index>& new_index) const {
  std::vector<Index> kept;
  for (Index v = 0; v < vertex_slots(); ++v) {
    const bool lives = has_vertex(v) || (v < isolated_.size() && isolated_[v]);
    if (!lives) continue;
    new_index[v] = static_cast<Index>(kept.size());
    kept.push_back(v);
  }
  return kept;
}

Mesh EditableMesh::to_mesh() const {
  Mesh mesh;
  std::vector<Index> new_index(vertex_slots(), no_index);
  const std::vector<Index> kept = squeezed_vertices(new_index);
  std::vector<Index> rows;
  rows.reserve(kept.size());
  mesh.positions.reserve(kept.size());
  for (const Index v : kept) {
    mesh.positions.push_back(positions_[v]);
    rows.push_back(vertex_rows_[v]);
  }
  mesh.vertex_columns = vertex_columns_.select(rows);
  rows.clear();
  mesh.faces.reserve(face_slots());
  for (Index f = 0; f < face_slots(); ++f) {
    if (!has_face(f)) continue;
    const std::size_t h = std::size_t{3} * f;
    mesh.faces.push_back(
        {new_index[sources_[h]], new_index[sources_[h + 1]], new_index[sources_[h + 2]]});
    rows.push_back(face_rows_[f]);
  }
  mesh.face_columns = face_columns_.select(rows);
  return mesh;
}

Vec3 EditableMesh::face_normal(Index face) const {
  const std::size_t h = std::size_t{3} * face;
  return normal_of(positions_[sources_[h]], positions_[sources_[h + 1]],
                   positions_[sources_[h + 2]]);
}

Index EditableMesh::valence(Index vertex) const {
  Index count = 0;
  for_each_neighbor(vertex, [&](Index, Index) { ++count; });
  return count;
}

/// Whether a vertex that is not on the border has exactly three neighbors.
bool EditableMesh::has_three_neighbors(Index vertex) const {
  Index halfedge = outgoing_[vertex];
  for (int i = 0; i < 3; ++i) halfedge = opposites_[previous_halfedge(halfedge)];
  return halfedge == outgoing_[vertex];
}

bool EditableMesh::are_neighbors(Index first, Index second) const {
  bool found = false;
  for_each_neighbor(first, [&](Index neighbor, Index) { found |= neighbor == second; });
  return found;
}

void EditableMesh::set_feature(Index halfedge, bool is_feature) {
  if (features_.empty()) features_.assign(sources_.size(), 0);
  features_[halfedge] = is_feature;
  if (!is_border(halfedge)) features_[opposite(halfedge)] = is_feature;
}

void EditableMesh::copy_feature(Index from, Index to) {
  if (!features_.empty()) features_[to] = features_[from];
}

void EditableMesh::link(Index first, Index second) {
  opposites_[first] = second;
  opposites_[second] = first;
}

void EditableMesh::set_opposite(Index halfedge, Index opposite) {
  opposites_[halfedge] = opposite;
  if (opposite != no_index) opposites_[opposite] = halfedge;
}

Index EditableMesh::append_face(Index a, Index b, Index c, Index row) {
  const Index face = face_slots();
  sources_.insert(sources_.end(), {a, b, c});
  opposites_.insert(opposites_.end(), 3, no_index);
  if (!features_.empty()) features_.insert(features_.end(), 3, 0);
  face_rows_.push_back(row);
  return face;
}

Index EditableMesh::append_row(const RowBlend& blend) {
  if (vertex_columns_.columns.empty()) return 0;
  vertex_columns_.append(blend);
  return vertex_row_count_++;
}

void EditableMesh::blend_attributes(Index vertex, const std::array<Index, 3>& sources,
                                    const std::array<double, 3>& weights) {
  if (!sizes_.empty()) {
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i) size += weights[i] * sizes_[sources[i]];
    sizes_[vertex] = size;
  }
  if (vertex_columns_.columns.empty()) return;
  vertex_rows_[vertex] = append_row(RowBlend{
      {vertex_rows_[sources[0]], vertex_rows_[sources[1]], vertex_rows_[sources[2]]}, weights});
}

Index EditableMesh::split(Index halfedge, const Vec3& position) {
  const Index h = halfedge;
  const Index o = opposites_[h];
  const Index from = source(h);
  const Index to = target(h);
  const Index middle = vertex_slots();
  positions_.push_back(position);
  vertex_rows_.push_back(
      append_row(RowBlend{{vertex_rows_[from], vertex_rows_[to], 0}, {0.5, 0.5, 0}}));
  if (!sizes_.empty()) sizes_.push_back(mean_size(from, to));
  if (!components_.empty()) components_.push_back(components_[from]);

  // The face of h keeps its half at `from`, and a new face takes the half at `to`.
  const Index n = next_halfedge(h);
  const Index half = 3 * append_face(middle, to, apex(h), face_rows_[h / 3]);
  sources_[n] = middle;
  set_opposite(half + 1, opposites_[n]);
  link(n, half + 2);
  copy_feature(n, half + 1);
  copy_feature(half + 2, n);
  copy_feature(h, half);
  if (outgoing_[to] == n) outgoing_[to] = half + 1;
  outgoing_.push_back(half);
  if (o == no_index) return middle;

  // The face across the edge is halved in the same way.
  const Index p = previous_halfedge(o);
  const Index other = 3 * append_face(to, middle, apex(o), face_rows_[o / 3]);
  sources_[o] = middle;
  set_opposite(other + 2, opposites_[p]);
  link(p, other + 1);
  link(half, other);
  copy_feature(p, other + 2);
  copy_feature(other + 1, p);
  copy_feature(o, other);
  if (outgoing_[to] == o) outgoing_[to] = other;
  if (outgoing_[source(p)] == p) outgoing_[source(p)] = other + 2;
  return middle;
}

bool EditableMesh::can_collapse(Index halfedge) const {
  const Index from = source(halfedge);
  const Index to = target(halfedge);
  const Index o = opposites_[halfedge];
  const bool border_edge = o == no_index;
  if (is_border_vertex(from) && is_border_vertex(to) && !border_edge) return false;

  // The apex of each face that vanishes must keep a valid star: at least one face on a border, and
  // at least three elsewhere.
  for (const Index h : {halfedge, o}) {
    if (h == no_index) continue;
    const Index n = opposites_[next_halfedge(h)];
    const Index p = opposites_[previous_halfedge(h)];
    if (n == no_index && p == no_index) return false;
    if (!is_border_vertex(apex(h)) && has_three_neighbors(apex(h))) return false;
  }

  // Link condition: the ends have no common neighbors except the apexes.
  return count_common_neighbors(from, to) == (border_edge ? 1U : 2U);
}

/// Returns the number of common neighbors of two adjacent vertices.
Index EditableMesh::count_common_neighbors(Index from, Index to) const {
  constexpr std::size_t usual = 24;  // neighbors without an allocation; affects time only
  std::array<Index, usual> ring;
  std::size_t count = 0;
  for_each_neighbor(to, [&](Index neighbor, Index) {
    if (count < usual) ring[count] = neighbor;
    ++count;
  });
  const auto is_neighbor_of_both = [&](Index neighbor) {
    if (count > usual) return are_neighbors(to, neighbor);
    const auto* end = ring.data() + count;
    return std::find(static_cast<const Index*>(ring.data()), end, neighbor) != end;
  };
  Index common = 0;
  for_each_neighbor(from, [&](Index neighbor, Index) {
    if (neighbor != to && is_neighbor_of_both(neighbor)) ++common;
  });
  return common;
}

/// Joins the two remaining edges of a face that vanishes into one.
void EditableMesh::close_gap(Index removed, Index other_removed) {
  const Index first = opposites_[removed];
  const Index second = opposites_[other_removed];
  const bool feature = is_feature(removed) || is_feature(other_removed);
  if (first != no_index) opposites_[first] = second;
  if (second != no_index) opposites_[second] = first;
  if (!has_features()) return;
  if (first != no_index) features_[first] = feature;
  if (second != no_index) features_[second] = feature;
}

/// Sets the first outgoing halfedge of a vertex, found from any of its outgoing halfedges.
void EditableMesh::rewind_outgoing(Index vertex, Index any_outgoing) {
  Index halfedge = any_outgoing;
  while (opposites_[halfedge] != no_index) {
    halfedge = next_halfedge(opposites_[halfedge]);
    if (halfedge == any_outgoing) break;
  }
  outgoing_[vertex] = halfedge;
}

void EditableMesh::collapse(Index halfedge, const Vec3& position, double source_weight) {
  const Index from = source(halfedge);
  const Index to = target(halfedge);
  const Index o = opposites_[halfedge];
  positions_[to] = position;
  if (source_weight != 0)
    blend_attributes(to, {to, from, to}, {1 - source_weight, source_weight, 0});
  Index moved = outgoing_[from];
  const Index first = moved;
  do {  // for_each_outgoing() cannot be used, because the sources change meanwhile
    const Index next = opposites_[previous_halfedge(moved)];
    sources_[moved] = to;
    moved = next;
  } while (moved != first && moved != no_index);

  Index outgoing = no_index;
  for (const Index h : {halfedge, o}) {
    if (h == no_index) continue;
    const Index n = next_halfedge(h);
    const Index p = previous_halfedge(h);
    // On either side of the edge, p leaves the apex and n arrives there.
    close_gap(n, p);
    if (outgoing_[source(p)] == p) outgoing_[source(p)] = opposites_[n];
    const Index leaves_kept = opposites_[p];
    const Index arrives_kept = opposites_[n];
    outgoing = leaves_kept != no_index ? leaves_kept : next_halfedge(arrives_kept);
  }
  for (const Index h : {halfedge, o}) {
    if (h != no_index) remove_face(h / 3);
  }
  remove_vertex(from);
  rewind_outgoing(to, outgoing);
}

bool EditableMesh::can_flip(Index halfedge) const {
  const Index o = opposites_[halfedge];
  return o != no_index && apex(halfedge) != apex(o) && !are_neighbors(apex(halfedge), apex(o));
}

void EditableMesh::flip(Index halfedge) {
  const Index h = halfedge;
  const Index o = opposites_[h];
  const Index hn = next_halfedge(h);
  const Index hp = previous_halfedge(h);
  const Index on = next_halfedge(o);
  const Index op = previous_halfedge(o);
  const Index from = source(h);
  const Index to = target(h);
  const Index left = apex(h);
  const Index right = apex(o);
  const std::array<Index, 4> across{opposites_[hp], opposites_[on], opposites_[op], opposites_[hn]};
  const std::array<bool, 4> sharp{is_feature(hp), is_feature(on), is_feature(op), is_feature(hn)};
  // The new faces have the rim left-from, from-right, right-to, to-left.
  const std::array<Index, 4> rim{hn, hp, on, op};

  sources_[h] = right;
  sources_[hn] = left;
  sources_[hp] = from;
  sources_[o] = left;
  sources_[on] = right;
  sources_[op] = to;
  for (std::size_t i = 0; i < 4; ++i) {
    set_opposite(rim[i], across[i]);
    if (has_features()) features_[rim[i]] = sharp[i];
  }
  if (outgoing_[from] == h || outgoing_[from] == on) outgoing_[from] = hp;
  if (outgoing_[to] == o || outgoing_[to] == hn) outgoing_[to] = op;
  if (outgoing_[left] == hp) outgoing_[left] = hn;
  if (outgoing_[right] == op) outgoing_[right] = on;
}

void EditableMesh::remove_face(Index face) {
  for (Index corner = 0; corner < 3; ++corner) sources_[3 * face + corner] = no_index;
}

}  // namespace transformesh
