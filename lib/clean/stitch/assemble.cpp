#include "clean/stitch/assemble.h"

#include <atomic>

#include "clean/arrange/refine.h"
#include "clean/stitch/pair_pieces.h"
#include "clean/stitch/split_singular_edges.h"
#include "mesh/umbrellas.h"
#include "support/atomic_minimum.h"
#include "support/numbered_selection.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

class Assembler {
 public:
  Assembler(const Mesh& input, const Arrangement& arrangement, const std::vector<char>& kept);
  Assembly assemble();

 private:
  void choose_old_vertices();
  void number_vertices();
  void set_vertex(Index umbrella, Index vertex);
  Index piece_face(const Piece& piece) const;
  void add_faces();
  void split_edges();
  void set_columns();

  const Mesh& input_;
  const Arrangement& arrangement_;
  const std::vector<char>& kept_;
  PiecePairs pairs_;
  Umbrellas umbrellas_;
  /// For each umbrella, the input vertex that becomes its vertex, or no_index. An umbrella is a set
  /// of connected pieces around a point; it gets one vertex.
  std::vector<Index> old_vertex_;
  /// For each input vertex, the umbrella (connected pieces around a point) whose vertex it becomes,
  /// or no_index.
  std::vector<Index> umbrella_of_;
  /// For each umbrella (connected pieces around a point), its vertex in the result.
  RawVector<Index> vertex_of_;
  bool has_vertex_rows_;  ///< false if vertices have no attribute columns
  std::vector<RowBlend> vertex_rows_;
  Assembly result_;
};

Assembler::Assembler(const Mesh& input, const Arrangement& arrangement,
                     const std::vector<char>& kept)
    : input_(input),
      arrangement_(arrangement),
      kept_(kept),
      pairs_(pair_pieces(arrangement, kept)),
      has_vertex_rows_(!input.vertex_columns.columns.empty()) {
  RawVector<Face> faces(arrangement.pieces.size());
  parallel_for_each(faces.size(), [&](Index p) { faces[p] = arrangement.pieces[p].corners; });
  umbrellas_ = find_oriented_umbrellas(faces, pairs_.opposite, kept);
}

// Returns the input face from which a piece is cut. If coincident faces contain the piece, prefers
// one with the orientation of the piece.
Index Assembler::piece_face(const Piece& piece) const {
  for (const PieceSource& source : arrangement_.sources_of(piece)) {
    if (!source.reversed) return arrangement_.welded->face_of[source.face];
  }
  return arrangement_.welded->face_of[arrangement_.sources_of(piece).front().face];
}

// Assigns an input vertex to each umbrella (connected pieces around a point). Candidates are the
// corners at this point of the input faces that contain the pieces; the one with the smallest index
// is taken. If several umbrellas would get the same vertex, only the first of them gets it.
void Assembler::choose_old_vertices() {
  const WeldedMesh& welded = *arrangement_.welded;
  old_vertex_.assign(umbrellas_.vertex_of.size(), no_index);
  umbrella_of_.assign(input_.positions.size(), no_index);
  parallel_for_each(arrangement_.pieces.size(), [&](Index p) {
    if (!kept_[p]) return;
    const Piece& piece = arrangement_.pieces[p];
    for (const Index vertex : input_.faces[piece_face(piece)])
      for (Index i = 0; i < 3; ++i)
        if (welded.point_of[vertex] == piece.corners[i])
          lower_to(std::atomic_ref(old_vertex_[umbrellas_.of_corner[3 * p + i]]), vertex);
  });
  parallel_for_each(old_vertex_.size(), [&](Index u) {
    if (old_vertex_[u] != no_index) lower_to(std::atomic_ref(umbrella_of_[old_vertex_[u]]), u);
  });
  parallel_for_each(old_vertex_.size(), [&](Index u) {
    if (old_vertex_[u] != no_index && umbrella_of_[old_vertex_[u]] != u) old_vertex_[u] = no_index;
  });
}

// Numbers the vertices of the result. Input vertices come first, in their order. The remaining
// vertices follow in the order of their umbrellas (connected pieces around a point).
void Assembler::number_vertices() {
  choose_old_vertices();
  const NumberedSelection old(umbrella_of_.size(),
                              [&](std::size_t v) { return umbrella_of_[v] != no_index; });
  const NumberedSelection others(old_vertex_.size(),
                                 [&](std::size_t u) { return old_vertex_[u] == no_index; });
  const std::size_t count = old_vertex_.size();
  vertex_of_.resize(count);
  result_.mesh.positions.resize(count);
  result_.vertex_is_new.resize(count);
  result_.input_vertex.resize(count);
  if (has_vertex_rows_) vertex_rows_.resize(count);
  old.visit(
      [&](std::size_t v, std::size_t n) { set_vertex(umbrella_of_[v], static_cast<Index>(n)); });
  others.visit([&](std::size_t u, std::size_t n) {
    set_vertex(static_cast<Index>(u), static_cast<Index>(old.size() + n));
  });
  result_.copies = NumberedSelection(count, [&](std::size_t u) {
                     return old_vertex_[u] == no_index && !result_.vertex_is_new[vertex_of_[u]];
                   }).size();
}

void Assembler::set_vertex(Index umbrella, Index vertex) {
  const WeldedMesh& welded = *arrangement_.welded;
  const Index point = umbrellas_.vertex_of[umbrella], old = old_vertex_[umbrella];
  const bool is_new = point >= welded.points.size();
  vertex_of_[umbrella] = vertex;
  result_.vertex_is_new[vertex] = is_new ? 1 : 0;
  result_.input_vertex[vertex] = is_new ? no_index : welded.vertex_of[point];
  const Vec3 position = old != no_index ? input_.positions[old] : arrangement_.position(point);
  result_.mesh.positions[vertex] = position;
  if (!has_vertex_rows_) return;
  const Index face = piece_face(arrangement_.pieces[umbrellas_.first_corner[umbrella] / 3]);
  vertex_rows_[vertex] =
      old != no_index ? RowBlend{{old, 0, 0}, {1, 0, 0}} : row_on_face(input_, face, position);
}

void Assembler::add_faces() {
  const NumberedSelection kept(kept_.size(), [&](std::size_t p) { return kept_[p] != 0; });
  result_.mesh.faces.resize(kept.size());
  result_.face_is_new.resize(kept.size());
  result_.source_face.resize(kept.size());
  kept.visit([&](std::size_t p, std::size_t face) {
    for (std::size_t i = 0; i < 3; ++i)
      result_.mesh.faces[face][i] = vertex_of_[umbrellas_.of_corner[3 * p + i]];
    result_.face_is_new[face] = p < arrangement_.whole_pieces ? 0 : 1;
    result_.source_face[face] = piece_face(arrangement_.pieces[p]);
  });
}

// Splits edges that have more than two faces even after their ends are duplicated.
void Assembler::split_edges() {
  if (!pairs_.has_singular_edges) return;
  std::vector<Index> opposite =
      opposites_of_kept(pairs_.opposite, kept_, result_.mesh.faces.size());
  const EdgeSplits splits = split_singular_edges(result_.mesh, opposite);
  result_.split_edges = splits.edges;
  for (const EdgeSplits::Midpoint& midpoint : splits.vertices) {
    const Vec3& position = result_.mesh.positions[result_.vertex_is_new.size()];
    result_.vertex_is_new.push_back(1);
    result_.input_vertex.push_back(no_index);
    if (has_vertex_rows_)
      vertex_rows_.push_back(row_on_face(input_, result_.source_face[midpoint.face], position));
  }
  for (const Index face : splits.cut_faces) {
    result_.face_is_new[face] = 1;
  }
  for (const Index face : splits.face_source) {
    result_.face_is_new.push_back(1);
    result_.source_face.push_back(result_.source_face[face]);
  }
}

void Assembler::set_columns() {
  result_.mesh.vertex_columns = input_.vertex_columns.blend(vertex_rows_);
  result_.mesh.face_columns = input_.face_columns.select(result_.source_face);
}

Assembly Assembler::assemble() {
  number_vertices();
  add_faces();
  split_edges();
  set_columns();
  return std::move(result_);
}

}  // namespace

Assembly assemble(const Mesh& input, const Arrangement& arrangement,
                  const std::vector<char>& kept) {
  return Assembler(input, arrangement, kept).assemble();
}

}  // namespace transformesh
