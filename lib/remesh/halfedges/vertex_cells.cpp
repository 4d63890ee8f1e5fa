#include "remesh/halfedges/vertex_cells.h"

#include <algorithm>
#include <limits>

#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t faces_per_task = 4096;  ///< affects time only
constexpr std::size_t faces_at_once = 64;     ///< affects time only
/// At most one slot in this many of the hash table is used: most searches find nothing and end at
/// the first free slot. A fuller table takes less memory and longer searches.
constexpr std::size_t most_full = 6;

std::vector<NormalCone> cones_of_faces(const EditableMesh& mesh) {
  std::vector<NormalCone> cones(mesh.face_slots());
  parallel_for(cones.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    std::array<Vec3, faces_at_once> normals;
    for (std::size_t f = first; f < last; f += faces_at_once) {
      const std::size_t count = std::min(faces_at_once, last - f);
      for (std::size_t i = 0; i < count; ++i) {
        const auto face = static_cast<Index>(f + i);
        normals[i].setZero();
        if (!mesh.has_face(face)) continue;
        const Triangle triangle = mesh.triangle(face);
        normals[i] = reliable_normal(triangle[0], triangle[1], triangle[2]);
      }
      find_cones(std::span(normals).first(count), std::span(cones).subspan(f, count));
    }
  });
  return cones;
}

/// Collects the faces of the component of the vertex; returns whether it has no border.
bool gather_component(const EditableMesh& mesh, Index seed, std::vector<char>& reached,
                      std::vector<Index>& faces) {
  bool closed = true;
  faces.assign(1, mesh.outgoing(seed) / 3);
  reached[faces[0]] = 1;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (Index h = 3 * faces[i]; h < 3 * faces[i] + 3; ++h) {
      const Index opposite = mesh.opposite(h);
      closed &= opposite != no_index;
      if (opposite == no_index || reached[opposite / 3]) continue;
      reached[opposite / 3] = 1;
      faces.push_back(opposite / 3);
    }
  }
  return closed;
}

}  // namespace

std::vector<Index> closed_components(const EditableMesh& mesh) {
  std::vector<Index> components(mesh.vertex_slots(), no_index);
  std::vector<char> reached(mesh.face_slots(), 0);
  std::vector<Index> faces;
  for (Index seed = 0; seed < mesh.vertex_slots(); ++seed) {
    if (!mesh.has_vertex(seed) || reached[mesh.outgoing(seed) / 3]) continue;
    if (!gather_component(mesh, seed, reached, faces)) continue;
    for (const Index face : faces)
      for (Index h = 3 * face; h < 3 * face + 3; ++h) components[mesh.source(h)] = seed;
  }
  return components;
}

VertexCells::VertexCells(const EditableMesh& mesh, double cell_size)
    : mesh_(mesh), cell_size_(cell_size), vertices_(mesh.vertex_slots()) {
  Vec3 low = Vec3::Constant(HUGE_VAL);
  Vec3 high = -low;
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    if (!mesh.has_vertex(v)) continue;
    low = low.cwiseMin(mesh.position(v));
    high = high.cwiseMax(mesh.position(v));
  }
  // The cell size leaves a margin of cells on each side, and limits the number of cells to the
  // number of different keys.
  cell_size_ = std::max(cell_size_, (high - low).maxCoeff() / (1 << (key_bits - 3)));
  origin_ = low - Vec3::Constant(8 * cell_size_);
  std::vector<NormalCone> cones;
  std::vector<Index> found;
  parallel_invoke(
      [&] {
        if (mesh.components().empty()) found = closed_components(mesh);
      },
      [&] { cones = cones_of_faces(mesh); });
  const std::span<const Index> components = found.empty() ? mesh.components() : found;
  for (Index v = 0; v < mesh.vertex_slots(); ++v) vertices_[v].component = components[v];
  fill(cones);
}

VertexCells::Key VertexCells::key_of(const Vec3& position) const {
  const Vec3 at = (position - origin_) / cell_size_;
  Key key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double limit = (1 << key_bits) - 2;
    key = (key << key_bits) | static_cast<Key>(std::clamp(at[axis], 1.0, limit));
  }
  return key;
}

void VertexCells::enter_in_table(Index cell) {
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = slot_of(cells_[cell].key);
  while (table_[slot & mask] != no_index) ++slot;
  table_[slot & mask] = cell;
}

void VertexCells::grow_table() {
  table_.assign(std::max<std::size_t>(1024, 2 * table_.size()), no_index);
  for (Index cell = 0; cell < cells_.size(); ++cell) enter_in_table(cell);
}

Index VertexCells::make_cell(Key key, Index component) {
  const auto cell = static_cast<Index>(cells_.size());
  const NormalCone cone = component == no_index ? 0 : all_directions;
  cells_.push_back({key, cone, cone, no_index, component});
  around_.emplace_back();
  if (most_full * cells_.size() > table_.size()) {
    grow_table();
  } else {
    enter_in_table(cell);
  }
  return cell;
}

template <class Visit>
void VertexCells::for_each_cell_around(Index cell, const Visit& visit) const {
  const CellsAround& around = around_[cell];
  for (Index i = 0; i < around.count; ++i) visit(around.cells[i]);
}

/// Enters the cell into its own list of near cells. For each existing cell at one of the given
/// offsets, enters both cells into each other's lists.
void VertexCells::find_cells_around(Index cell, std::span<const Key> offsets) {
  const auto enter = [&](Index at, Index other) { around_[at].cells[around_[at].count++] = other; };
  enter(cell, cell);
  for (const Key offset : offsets) {
    const Index other = find_cell(cells_[cell].key + offset);
    if (other == no_index) continue;
    enter(cell, other);
    enter(other, cell);
  }
}

void VertexCells::fill(std::span<const NormalCone> cones) {
  grow_table();
  Index cell = no_index;
  for (Index v = 0; v < mesh_.vertex_slots(); ++v) {
    if (!mesh_.has_vertex(v)) continue;
    // Consecutive vertices are often in the same cell, which saves the search.
    const Key key = key_of(mesh_.position(v));
    if (cell == no_index || cells_[cell].key != key) cell = find_cell(key);
    if (cell == no_index) cell = make_cell(key, vertices_[v].component);
    if (cells_[cell].component != vertices_[v].component) cells_[cell].cone = 0;
    insert(v, cell);
  }
  restrict_to_faces(cones);
  const auto lower = std::span(offsets_around).first<offsets_around.size() / 2>();
  for (Index c = 0; c < cells_.size(); ++c) find_cells_around(c, lower);
  for (Index c = 0; c < cells_.size(); ++c) dilate(c);
  if (mesh_.has_sizes()) measure_edges();
}

void VertexCells::restrict_to_faces(std::span<const NormalCone> cones) {
  for (Index face = 0; face < mesh_.face_slots(); ++face) {
    if (!mesh_.has_face(face)) continue;
    for (Index h = 3 * face; h < 3 * face + 3; ++h) vertices_[mesh_.source(h)].cone &= cones[face];
  }
  for (const Vertex& vertex : vertices_)
    if (vertex.cell != no_index) cells_[vertex.cell].cone &= vertex.cone;
}

void VertexCells::measure_edges() {
  for (Vertex& vertex : vertices_) vertex.longest_squared = 0;
  for (Index face = 0; face < mesh_.face_slots(); ++face) {
    if (!mesh_.has_face(face)) continue;
    double longest = 0;
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
      longest = std::max(longest, mesh_.squared_length(h));
    for (Index h = 3 * face; h < 3 * face + 3; ++h) stretch(mesh_.source(h), longest);
  }
}

void VertexCells::stretch(Index vertex, double longest_squared) {
  constexpr double margin = 1 + 1e-6;  // exceeds the rounding of a double to float
  const float rounded_up =
      std::max(static_cast<float>(margin * longest_squared), std::numeric_limits<float>::min());
  vertices_[vertex].longest_squared = std::max(vertices_[vertex].longest_squared, rounded_up);
}

void VertexCells::dilate(Index cell) {
  Cell& own = cells_[cell];
  own.cone_around = own.cone;
  for_each_cell_around(cell, [&](Index other) {
    const bool alike = cells_[other].component == own.component;
    own.cone_around &= alike ? cells_[other].cone : 0;
  });
}

void VertexCells::restrict_cell(Index cell, NormalCone cone) {
  const NormalCone left = cells_[cell].cone & cone;
  if (left == cells_[cell].cone) return;
  cells_[cell].cone = left;
  for_each_cell_around(cell, [&](Index other) { cells_[other].cone_around &= left; });
}

void VertexCells::insert(Index vertex, Index cell) {
  const Index next = cells_[cell].first_vertex;
  vertices_[vertex].cell = cell;
  vertices_[vertex].next = next;
  vertices_[vertex].previous = no_index;
  if (next != no_index) vertices_[next].previous = vertex;
  cells_[cell].first_vertex = vertex;
}

void VertexCells::remove(Index vertex) {
  const Index next = vertices_[vertex].next;
  const Index previous = vertices_[vertex].previous;
  if (next != no_index) vertices_[next].previous = previous;
  if (previous != no_index) {
    vertices_[previous].next = next;
  } else {
    cells_[vertices_[vertex].cell].first_vertex = next;
  }
}

void VertexCells::update(Index vertex) {
  const Key key = key_of(mesh_.position(vertex));
  if (key != cell_of(vertex).key) change_cell(vertex, key);
}

void VertexCells::restrict(std::span<const Index> vertices, NormalCone cone,
                           double longest_squared) {
  for (const Index v : vertices) {
    Vertex& vertex = vertices_[v];
    vertex.cone &= cone;
    if ((cells_[vertex.cell].cone & ~cone) != 0) restrict_cell(vertex.cell, cone);
  }
  if (!mesh_.has_sizes()) return;
  for (const Index v : vertices) stretch(v, longest_squared);
}

void VertexCells::change_cell(Index vertex, Key key) {
  const Index component = vertices_[vertex].component;
  remove(vertex);
  Index cell = find_cell(key);
  if (cell == no_index) {
    cell = make_cell(key, component);
    find_cells_around(cell, offsets_around);
    dilate(cell);
    for_each_cell_around(cell, [&](Index other) {
      if (cells_[other].component != component) cells_[other].cone_around = 0;
    });
  } else if (cells_[cell].component != component) {
    restrict_cell(cell, 0);
  }
  insert(vertex, cell);
}

}  // namespace transformesh
