#include "tm/remesh/vertex_cells.h"

#include <algorithm>
#include <limits>

namespace transformesh {

VertexCells::VertexCells(const EditableMesh& mesh, double cell_size)
    : mesh_(mesh), cell_size_(cell_size), vertices_(mesh.vertex_slots()) {
  Vec3 low = Vec3::Constant(HUGE_VAL);
  Vec3 high = -low;
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    if (!mesh.has_vertex(v)) continue;
    low = low.cwiseMin(mesh.position(v));
    high = high.cwiseMax(mesh.position(v));
  }
  // There is a margin of cells on each side, and no more cells than a key can count.
  cell_size_ = std::max(cell_size_, (high - low).maxCoeff() / (1 << (key_bits - 3)));
  origin_ = low - Vec3::Constant(8 * cell_size_);
  label_components();
  fill();
}

void VertexCells::label_components() {
  std::vector<char> reached(mesh_.face_slots(), 0);
  std::vector<Index> faces;
  for (Index seed = 0; seed < mesh_.vertex_slots(); ++seed) {
    if (!mesh_.has_vertex(seed) || reached[mesh_.outgoing(seed) / 3]) continue;
    if (!gather_component(seed, reached, faces)) continue;
    for (const Index face : faces) {
      for (Index h = 3 * face; h < 3 * face + 3; ++h) vertices_[mesh_.source(h)].component = seed;
    }
  }
}

/// Collects the faces of the component of that vertex, and says whether it is closed.
bool VertexCells::gather_component(Index seed, std::vector<char>& reached,
                                   std::vector<Index>& faces) const {
  bool closed = true;
  faces.assign(1, mesh_.outgoing(seed) / 3);
  reached[faces[0]] = 1;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (Index h = 3 * faces[i]; h < 3 * faces[i] + 3; ++h) {
      const Index opposite = mesh_.opposite(h);
      closed &= opposite != no_index;
      if (opposite == no_index || reached[opposite / 3]) continue;
      reached[opposite / 3] = 1;
      faces.push_back(opposite / 3);
    }
  }
  return closed;
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
  if (2 * cells_.size() > table_.size()) {
    grow_table();
  } else {
    enter_in_table(cell);
  }
  return cell;
}

template <class Visit>
void VertexCells::for_each_cell_around(Key key, const Visit& visit) const {
  for (Key dx = -1; dx <= 1; ++dx) {
    for (Key dy = -1; dy <= 1; ++dy) {
      for (Key dz = -1; dz <= 1; ++dz) {
        const Index cell =
            find_cell(key + dx * (Key{1} << (2 * key_bits)) + dy * (Key{1} << key_bits) + dz);
        if (cell != no_index) visit(cell);
      }
    }
  }
}

void VertexCells::fill() {
  grow_table();
  for (Index v = 0; v < mesh_.vertex_slots(); ++v) {
    if (!mesh_.has_vertex(v)) continue;
    const Key key = key_of(mesh_.position(v));
    Index cell = find_cell(key);
    if (cell == no_index) cell = make_cell(key, vertices_[v].component);
    if (cells_[cell].component != vertices_[v].component) cells_[cell].cone = 0;
    insert(v, cell);
  }
  for (Index face = 0; face < mesh_.face_slots(); ++face) {
    if (!mesh_.has_face(face)) continue;
    const NormalCone cone = cone_of(mesh_.face_normal(face));
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      cells_[vertices_[mesh_.source(h)].cell].cone &= cone;
      vertices_[mesh_.source(h)].cone &= cone;
    }
  }
  for (Cell& cell : cells_) dilate(cell);
  if (mesh_.has_sizes()) measure_edges();
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
  constexpr double margin = 1 + 1e-6;
  const float rounded_up =
      std::max(static_cast<float>(margin * longest_squared), std::numeric_limits<float>::min());
  vertices_[vertex].longest_squared = std::max(vertices_[vertex].longest_squared, rounded_up);
}

void VertexCells::dilate(Cell& cell) const {
  cell.cone_around = cell.cone;
  for_each_cell_around(cell.key, [&](Index other) {
    const bool alike = cells_[other].component == cell.component;
    cell.cone_around &= alike ? cells_[other].cone : 0;
  });
}

void VertexCells::restrict_cell(Index cell, NormalCone cone) {
  const NormalCone left = cells_[cell].cone & cone;
  if (left == cells_[cell].cone) return;
  cells_[cell].cone = left;
  for_each_cell_around(cells_[cell].key, [&](Index other) { cells_[other].cone_around &= left; });
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

void VertexCells::restrict(Index vertex, NormalCone cone, double longest_squared) {
  restrict_cell(vertices_[vertex].cell, cone);
  vertices_[vertex].cone &= cone;
  stretch(vertex, longest_squared);
}

void VertexCells::change_cell(Index vertex, Key key) {
  const Index component = vertices_[vertex].component;
  remove(vertex);
  Index cell = find_cell(key);
  if (cell == no_index) {
    cell = make_cell(key, component);
    dilate(cells_[cell]);
    for_each_cell_around(key, [&](Index other) {
      if (cells_[other].component != component) cells_[other].cone_around = 0;
    });
  } else if (cells_[cell].component != component) {
    restrict_cell(cell, 0);
  }
  insert(vertex, cell);
}

}  // namespace transformesh
