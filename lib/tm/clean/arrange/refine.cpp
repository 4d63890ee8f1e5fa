#include "tm/clean/arrange/refine.h"

#include <memory>

#include "tm/clean/arrange/arrange.h"
#include "tm/clean/arrange/face_row.h"

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
    const Index mesh_face = arrangement_.soup->face_of[source.face];
    Face face;
    for (std::size_t i = 0; i < 3; ++i) face[i] = vertex(piece.corners[i], mesh_face);
    if (source.reversed) std::swap(face[1], face[2]);
    result_.faces.push_back(face);
    face_rows_.push_back(mesh_face);
  }

  // Corners of the face itself keep their vertex, though others may be at the same place.
  Index vertex(Index point, Index mesh_face) {
    const Soup& soup = *arrangement_.soup;
    if (point < soup.points.size()) {
      for (const Index v : mesh_.faces[mesh_face]) {
        if (soup.point_of[v] == point) return v;
      }
      return soup.vertex_of[point];
    }
    Index& known = new_vertex_[point - soup.points.size()];
    if (known == no_index) {
      known = static_cast<Index>(result_.positions.size());
      result_.positions.push_back(arrangement_.position(point));
      result_.vertex_columns.append(row_on_face(mesh_, mesh_face, result_.positions.back()));
    }
    return known;
  }

  void set_face_columns() {
    result_.face_columns = mesh_.face_columns.select(face_rows_);
    result_.face_columns.erase("source_face");
    Column& column = result_.face_columns.get("source_face", Scalar::int32, result_.faces.size());
    for (std::size_t f = 0; f < face_rows_.size(); ++f) column.values[f] = face_rows_[f];
  }

  const Mesh& mesh_;
  const Arrangement& arrangement_;
  std::vector<Index> new_vertex_;  ///< per cut point
  std::vector<Index> face_rows_;
  Mesh result_;
};

}  // namespace

Mesh refine(const Mesh& mesh, const Progress& progress) {
  const auto soup = std::make_shared<const Soup>(make_soup(mesh));
  const Arrangement arrangement = arrange(soup, find_intersections(*soup, progress), progress);
  return Refiner(mesh, arrangement).refine();
}

}  // namespace transformesh
