#include "clean/box/replace_faces.h"

#include <algorithm>

namespace transformesh {
namespace {

class Placing {
 public:
  Placing(const Mesh& mesh, const std::vector<bool>& is_replaced, const CleanedFaces& cleaned)
      : mesh_(mesh),
        is_replaced_(is_replaced),
        cleaned_(cleaned),
        is_uncut_(find_uncut(mesh, cleaned)),
        vertex_of_(cleaned.mesh.positions.size(), no_index),
        is_claimed_(mesh.positions.size(), false) {}
  Mesh place();

 private:
  void claim(Index piece);
  void claim_vertices();
  void choose_faces();
  Face named(Index piece) const;

  const Mesh& mesh_;
  const std::vector<bool>& is_replaced_;
  const CleanedFaces& cleaned_;
  std::vector<bool> is_uncut_;
  /// For each vertex of the cleaned mesh its index in the result before unused vertices are
  /// removed. New vertices follow the vertices of the input mesh.
  std::vector<Index> vertex_of_;
  std::vector<bool> is_claimed_;
  std::vector<Index> new_vertices_;  ///< the new vertices, as indices in the cleaned mesh
  /// Faces of the result; corner indices as in `vertex_of_`.
  std::vector<Face> faces_;
  std::vector<Index> face_rows_;
};

// Assigns to each vertex of a piece the corner of its input face at the same position. Skips
// corners that were assigned to another vertex.
void Placing::claim(Index piece) {
  for (const Index v : cleaned_.mesh.faces[piece]) {
    if (vertex_of_[v] != no_index) continue;
    for (const Index old : mesh_.faces[cleaned_.source_face[piece]]) {
      if (is_claimed_[old] || mesh_.positions[old] != cleaned_.mesh.positions[v]) continue;
      is_claimed_[old] = true;
      vertex_of_[v] = old;
      break;
    }
  }
}

// Assigns input vertices to vertices of the cleaned mesh. If cleaning has duplicated a vertex, the
// duplicate at faces outside the box is the input vertex, and the others are new.
void Placing::claim_vertices() {
  for (const bool is_replaced : {false, true})
    for (const bool is_uncut : {true, false})
      for (Index p = 0; p < cleaned_.source_face.size(); ++p)
        if (is_replaced_[cleaned_.source_face[p]] == is_replaced && is_uncut_[p] == is_uncut &&
            (is_replaced || is_uncut))
          claim(p);
}

Face Placing::named(Index piece) const {
  Face face = cleaned_.mesh.faces[piece];
  for (Index& v : face) v = vertex_of_[v];
  return face;
}

void Placing::choose_faces() {
  std::vector<Index> uncut_piece(mesh_.faces.size(), no_index);
  std::vector<Index> others;
  for (Index p = 0; p < cleaned_.source_face.size(); ++p) {
    const Index source = cleaned_.source_face[p];
    if (!is_replaced_[source]) continue;
    if (is_uncut_[p] && uncut_piece[source] == no_index) {
      uncut_piece[source] = p;
    } else {
      others.push_back(p);
    }
    for (const Index v : cleaned_.mesh.faces[p]) {
      if (vertex_of_[v] != no_index) continue;
      vertex_of_[v] = static_cast<Index>(mesh_.positions.size() + new_vertices_.size());
      new_vertices_.push_back(v);
    }
  }
  const auto add = [&](const Face& face, Index source) {
    faces_.push_back(face);
    face_rows_.push_back(source);
  };
  for (Index f = 0; f < mesh_.faces.size(); ++f) {
    if (!is_replaced_[f]) add(mesh_.faces[f], f);
    if (uncut_piece[f] != no_index) add(named(uncut_piece[f]), f);
  }
  for (const Index p : others) add(named(p), cleaned_.source_face[p]);
}

Mesh Placing::place() {
  claim_vertices();
  choose_faces();

  // Remove vertices that lost all their faces.
  std::vector<bool> is_gone(mesh_.positions.size(), false);
  for (const Face& face : mesh_.faces)
    for (const Index v : face) is_gone[v] = true;
  for (const Face& face : faces_)
    for (const Index v : face)
      if (v < is_gone.size()) is_gone[v] = false;
  std::vector<Index> number_of(mesh_.positions.size() + new_vertices_.size(), no_index), kept;
  for (Index v = 0; v < is_gone.size(); ++v) {
    if (is_gone[v]) continue;
    number_of[v] = static_cast<Index>(kept.size());
    kept.push_back(v);
  }
  for (std::size_t i = 0; i < new_vertices_.size(); ++i)
    number_of[mesh_.positions.size() + i] = static_cast<Index>(kept.size() + i);

  Mesh result;
  for (const Index v : kept) result.positions.push_back(mesh_.positions[v]);
  for (const Index v : new_vertices_) result.positions.push_back(cleaned_.mesh.positions[v]);
  for (Face& face : faces_)
    for (Index& v : face) v = number_of[v];
  result.faces = std::move(faces_);
  result.vertex_columns = mesh_.vertex_columns.select(kept);
  result.vertex_columns.concatenate(cleaned_.mesh.vertex_columns.select(new_vertices_), kept.size(),
                                    new_vertices_.size());
  result.face_columns = mesh_.face_columns.select(face_rows_);
  return result;
}

}  // namespace

std::vector<bool> find_uncut(const Mesh& mesh, const CleanedFaces& cleaned) {
  std::vector<bool> is_uncut(cleaned.source_face.size());
  for (std::size_t p = 0; p < is_uncut.size(); ++p) {
    const Face &piece = cleaned.mesh.faces[p], &source = mesh.faces[cleaned.source_face[p]];
    is_uncut[p] = true;
    for (std::size_t i = 0; i < 3; ++i)
      if (cleaned.mesh.positions[piece[i]] != mesh.positions[source[i]]) is_uncut[p] = false;
  }
  return is_uncut;
}

Mesh replace_faces(const Mesh& mesh, const std::vector<bool>& is_replaced,
                   const CleanedFaces& cleaned) {
  return Placing(mesh, is_replaced, cleaned).place();
}

}  // namespace transformesh
