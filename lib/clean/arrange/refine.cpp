#include "clean/arrange/refine.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>

#include "clean/arrange/arrange.h"
#include "clean/intersect/find_meetings.h"
#include "mesh/surface_columns.h"

namespace transformesh {
namespace {

class Refiner {
 public:
  Refiner(const Mesh& mesh, const Arrangement& arrangement)
      : mesh_(mesh),
        arrangement_(arrangement),
        new_vertex_(arrangement.cut_points.size(), no_index) {
    result_.positions = mesh.positions;
    result_.vertex_columns = mesh.vertex_columns;
  }

  Mesh refine() {
    for (const Piece& piece : arrangement_.pieces) {
      for (const PieceSource& source : arrangement_.sources_of(piece)) add_piece(piece, source);
    }
    set_face_columns();
    return std::move(result_);
  }

 private:
  void add_piece(const Piece& piece, const PieceSource& source) {
    const Index mesh_face = arrangement_.welded->face_of[source.face];
    Face face;
    for (std::size_t i = 0; i < 3; ++i) face[i] = vertex(piece.corners[i], mesh_face);
    if (source.reversed) std::swap(face[1], face[2]);
    result_.faces.push_back(face);
    face_rows_.push_back(mesh_face);
  }

  // Returns the vertex for a corner of a piece of `mesh_face`. If the corner of the piece is a
  // corner of the face, returns the vertex of this face, even if other vertices have the same
  // position.
  Index vertex(Index point, Index mesh_face) {
    const WeldedMesh& welded = *arrangement_.welded;
    if (point < welded.points.size()) {
      for (const Index v : mesh_.faces[mesh_face]) {
        if (welded.point_of[v] == point) return v;
      }
      return welded.vertex_of[point];
    }
    Index& known = new_vertex_[point - welded.points.size()];
    if (known == no_index) {
      known = static_cast<Index>(result_.positions.size());
      result_.positions.push_back(arrangement_.position(point));
      result_.vertex_columns.append(row_on_face(mesh_, mesh_face, result_.positions.back()));
    }
    return known;
  }

  void set_face_columns() {
    result_.face_columns = mesh_.face_columns.select(face_rows_);
    drop_source_points(result_);
    result_.face_columns.erase("source_face");
    Column& column = result_.face_columns.get("source_face", Scalar::int32, result_.faces.size());
    for (std::size_t f = 0; f < face_rows_.size(); ++f) column.values[f] = face_rows_[f];
  }

  const Mesh& mesh_;
  const Arrangement& arrangement_;
  std::vector<Index> new_vertex_;  ///< vertex of each point that cutting created, or no_index
  std::vector<Index> face_rows_;
  Mesh result_;
};

}  // namespace

Mesh refine(const Mesh& mesh, const Progress& progress) {
  const auto welded = std::make_shared<const WeldedMesh>(weld(mesh));
  const Arrangement arrangement = arrange(welded, find_meetings(*welded, progress), progress);
  return Refiner(mesh, arrangement).refine();
}

RowBlend row_on_face(const Mesh& mesh, Index face, const Vec3& position) {
  const Face& f = mesh.faces[face];
  const Vec3 &a = mesh.positions[f[0]], &b = mesh.positions[f[1]], &c = mesh.positions[f[2]];
  const Vec3 normal = (b - a).cross(c - a);
  const double total = normal.squaredNorm();
  std::array<double, 3> weight{1, 0, 0};
  if (total > 0) {
    weight[1] = std::clamp(normal.dot((position - a).cross(c - a)) / total, 0.0, 1.0);
    weight[2] = std::clamp(normal.dot((b - a).cross(position - a)) / total, 0.0, 1.0 - weight[1]);
    weight[0] = 1 - weight[1] - weight[2];
  }
  return {f, weight};
}

}  // namespace transformesh
