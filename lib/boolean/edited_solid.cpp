#include "boolean/edited_solid.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "geometry/axis_path.h"
#include "mesh/triangle.h"
#include "transformesh/components.h"

namespace transformesh {
namespace {

/// Number of faces in a block. In a solid of 1.5 million faces, a query tests the boxes of 23,000
/// blocks, and the faces in the few blocks that it touches. With larger blocks, more faces are
/// tested; with smaller blocks, more blocks. The result does not depend on the size.
constexpr std::size_t block_size = 64;

}  // namespace

EditedSolid::EditedSolid(Mesh mesh) : mesh_(std::move(mesh)) { index_faces(); }

void EditedSolid::index_faces() {
  frame_ = BoxFrame(mesh_.positions);
  boxes_.clear();
  blocks_.clear();
  for (const Face& face : mesh_.faces) add_box(face);
  gone_ = 0;
}

void EditedSolid::add_box(const Face& face) {
  if (boxes_.size() % block_size == 0) blocks_.emplace_back();
  boxes_.push_back(box_of(face));
  blocks_.back().extend(boxes_.back());
}

FloatBox EditedSolid::box_of(const Face& face) const {
  const Triangle t = triangle_of(mesh_.positions, face);
  return frame_.box(t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2]));
}

std::vector<Index> EditedSolid::faces_touching(const Box& box) const {
  const FloatBox wanted = frame_.box(box.min(), box.max());
  std::vector<Index> faces;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!blocks_[b].intersects(wanted)) continue;
    const std::size_t end = std::min(boxes_.size(), (b + 1) * block_size);
    for (std::size_t f = b * block_size; f < end; ++f)
      if (boxes_[f].intersects(wanted)) faces.push_back(static_cast<Index>(f));
  }
  return faces;
}

std::optional<int> EditedSolid::winding_at(const Vec3& point) const {
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 end = point;
    end[axis] = std::numeric_limits<double>::infinity();
    AxisPath path(point, end);
    for (const Index face : faces_touching({point, end}))
      path.add(triangle_of(mesh_.positions, mesh_.faces[face]));
    if (path.change()) return -*path.change();
  }
  return std::nullopt;
}

void EditedSolid::append_vertices(const Mesh& added, std::vector<Index>& vertex_of) {
  std::vector<Index> rows;
  for (Index v = 0; v < vertex_of.size(); ++v) {
    if (vertex_of[v] != no_index) continue;
    vertex_of[v] = static_cast<Index>(mesh_.positions.size() + rows.size());
    rows.push_back(v);
  }
  mesh_.vertex_columns.concatenate(added.vertex_columns.select(rows), mesh_.positions.size(),
                                   rows.size());
  for (const Index row : rows) mesh_.positions.push_back(added.positions[row]);
}

void EditedSolid::replace(const std::vector<Index>& removed, const Mesh& added,
                          std::vector<Index> vertex_of) {
  for (const Index face : removed) boxes_[face] = FloatBox();
  gone_ += removed.size();
  append_vertices(added, vertex_of);
  mesh_.face_columns.concatenate(added.face_columns, mesh_.faces.size(), added.faces.size());
  for (const auto& [a, b, c] : added.faces) {
    mesh_.faces.push_back({vertex_of[a], vertex_of[b], vertex_of[c]});
    add_box(mesh_.faces.back());
  }
  if (gone_ <= faces()) return;
  mesh_ = take();
  index_faces();
}

Mesh EditedSolid::take() {
  std::vector<bool> is_left(mesh_.faces.size());
  for (std::size_t f = 0; f < is_left.size(); ++f) is_left[f] = !boxes_[f].isEmpty();
  Mesh left = select_faces(mesh_, is_left);
  boxes_.clear();
  gone_ = 0;
  mesh_ = {};
  return left;
}

}  // namespace transformesh
