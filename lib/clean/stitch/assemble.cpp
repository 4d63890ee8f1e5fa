#include "clean/stitch/assemble.h"

#include <algorithm>

#include "clean/arrange/refine.h"
#include "clean/exterior/angular_order.h"
#include "clean/stitch/pair_halfedges.h"
#include "clean/stitch/split_singular_edges.h"
#include "mesh/umbrellas.h"

namespace transformesh {
namespace {

// Returns the open component of each piece. Empty if all pieces are closed.
std::vector<Index> open_components(const Arrangement& arrangement) {
  const std::vector<Index>& of_face = arrangement.welded->open_component;
  std::vector<Index> result;
  for (std::size_t p = 0; p < arrangement.pieces.size() && !of_face.empty(); ++p)
    result.push_back(of_face[arrangement.sources_of(arrangement.pieces[p]).front().face]);
  return result;
}

class Assembler {
 public:
  Assembler(const Mesh& input, const Arrangement& arrangement, const std::vector<char>& kept);
  Assembly assemble();

 private:
  void choose_old_vertices();
  void number_vertices();
  void add_vertex_row(Index umbrella);
  Index piece_face(const Piece& piece) const;
  void add_faces();
  void split_edges();
  void set_columns();

  const Mesh& input_;
  const Arrangement& arrangement_;
  const std::vector<char>& kept_;
  std::vector<Face> faces_;  ///< points at the corners of the kept pieces
  std::vector<Index> opposite_;
  bool has_singular_edges_ = false;
  Umbrellas umbrellas_;
  /// For each umbrella the input vertex that it keeps, or no_index.
  std::vector<Index> old_vertex_;
  std::vector<Index> example_;    ///< for each umbrella a halfedge that starts at its vertex
  std::vector<Index> vertex_of_;  ///< output vertex of each umbrella
  std::vector<RowBlend> vertex_rows_;
  std::vector<Index> face_rows_;
  std::vector<Index> output_opposite_;
  Assembly result_;
};

Assembler::Assembler(const Mesh& input, const Arrangement& arrangement,
                     const std::vector<char>& kept)
    : input_(input), arrangement_(arrangement), kept_(kept) {
  faces_.assign(arrangement.pieces.size(), Face{0, 0, 0});
  for (std::size_t p = 0; p < faces_.size(); ++p) {
    if (kept[p]) faces_[p] = arrangement.pieces[p].corners;
  }
  const Edges edges(faces_, arrangement.point_count());
  for (std::size_t e = 0; e < edges.size() && !has_singular_edges_; ++e)
    has_singular_edges_ = edges.halfedges(e).size() > 2;
  const auto sort = [&](std::span<const Index> halfedges) {
    return sort_around_edge(arrangement, halfedges);
  };
  opposite_ = pair_across_inside(faces_, edges, sort, open_components(arrangement));
  umbrellas_ = find_umbrellas(faces_, opposite_, kept);
}

// Returns the input face that a piece is cut from, preferably one with the orientation of the
// piece.
Index Assembler::piece_face(const Piece& piece) const {
  for (const PieceSource& source : arrangement_.sources_of(piece)) {
    if (!source.reversed) return arrangement_.welded->face_of[source.face];
  }
  return arrangement_.welded->face_of[arrangement_.sources_of(piece).front().face];
}

// Assigns to each umbrella the smallest input vertex at its corners, unless an earlier umbrella has
// that vertex.
void Assembler::choose_old_vertices() {
  const WeldedMesh& welded = *arrangement_.welded;
  old_vertex_.assign(umbrellas_.vertex_of.size(), no_index);
  example_.assign(umbrellas_.vertex_of.size(), no_index);
  for (Index h = 0; h < umbrellas_.of_corner.size(); ++h) {
    const Index umbrella = umbrellas_.of_corner[h];
    if (umbrella == no_index) continue;
    if (example_[umbrella] == no_index) example_[umbrella] = h;
    const Index point = umbrellas_.vertex_of[umbrella];
    if (point >= welded.points.size()) continue;
    for (const Index vertex : input_.faces[piece_face(arrangement_.pieces[h / 3])]) {
      if (welded.point_of[vertex] == point) {
        old_vertex_[umbrella] = std::min(old_vertex_[umbrella], vertex);
      }
    }
  }
  std::vector<char> taken(input_.positions.size(), 0);
  for (Index& vertex : old_vertex_) {
    if (vertex == no_index) continue;
    if (taken[vertex]) vertex = no_index;
    if (vertex != no_index) taken[vertex] = 1;
  }
}

// Numbers the kept input vertices first, in their order. The remaining vertices follow in the order
// of their umbrellas.
void Assembler::number_vertices() {
  choose_old_vertices();
  std::vector<Index> umbrella_of(input_.positions.size(), no_index);
  for (Index u = 0; u < old_vertex_.size(); ++u) {
    if (old_vertex_[u] != no_index) umbrella_of[old_vertex_[u]] = u;
  }
  vertex_of_.assign(old_vertex_.size(), no_index);
  result_.mesh.positions.reserve(old_vertex_.size());
  result_.vertex_is_new.reserve(old_vertex_.size());
  result_.input_vertex.reserve(old_vertex_.size());
  vertex_rows_.reserve(old_vertex_.size());
  for (const Index u : umbrella_of) {
    if (u != no_index) add_vertex_row(u);
  }
  for (Index u = 0; u < old_vertex_.size(); ++u) {
    if (old_vertex_[u] == no_index) add_vertex_row(u);
  }
}

void Assembler::add_vertex_row(Index umbrella) {
  const WeldedMesh& welded = *arrangement_.welded;
  const Index point = umbrellas_.vertex_of[umbrella];
  const bool is_new = point >= welded.points.size();
  vertex_of_[umbrella] = static_cast<Index>(result_.mesh.positions.size());
  result_.vertex_is_new.push_back(is_new ? 1 : 0);
  result_.input_vertex.push_back(is_new ? no_index : welded.vertex_of[point]);
  if (old_vertex_[umbrella] != no_index) {
    result_.mesh.positions.push_back(input_.positions[old_vertex_[umbrella]]);
    vertex_rows_.push_back({{old_vertex_[umbrella], 0, 0}, {1, 0, 0}});
    return;
  }
  const Vec3 position = arrangement_.position(point);
  result_.mesh.positions.push_back(position);
  const Index face = piece_face(arrangement_.pieces[example_[umbrella] / 3]);
  vertex_rows_.push_back(row_on_face(input_, face, position));
  if (!is_new) ++result_.copies;
}

void Assembler::add_faces() {
  const auto count = static_cast<std::size_t>(std::count(kept_.begin(), kept_.end(), 1));
  result_.mesh.faces.reserve(count);
  result_.face_is_new.reserve(count);
  face_rows_.reserve(count);
  output_opposite_.reserve(3 * count);
  std::vector<Index> output_face(faces_.size(), no_index);
  for (Index p = 0; p < faces_.size(); ++p) {
    if (!kept_[p]) continue;
    const Piece& piece = arrangement_.pieces[p];
    const bool is_whole = p < arrangement_.whole_pieces;
    output_face[p] = static_cast<Index>(result_.mesh.faces.size());
    Face face;
    for (Index i = 0; i < 3; ++i) face[i] = vertex_of_[umbrellas_.of_corner[3 * p + i]];
    result_.mesh.faces.push_back(face);
    result_.face_is_new.push_back(is_whole ? 0 : 1);
    face_rows_.push_back(piece_face(piece));
  }
  for (Index h = 0; h < opposite_.size(); ++h) {
    if (output_face[h / 3] == no_index) continue;
    const Index across = opposite_[h];
    output_opposite_.push_back(across == no_index ? no_index
                                                  : 3 * output_face[across / 3] + across % 3);
  }
}

// Splits edges that still have more than two faces after their ends are duplicated.
void Assembler::split_edges() {
  if (!has_singular_edges_) return;
  const EdgeSplits splits = split_singular_edges(result_.mesh, output_opposite_);
  result_.split_edges = splits.edges;
  for (const EdgeSplits::Midpoint& midpoint : splits.vertices) {
    result_.vertex_is_new.push_back(1);
    result_.input_vertex.push_back(no_index);
    vertex_rows_.push_back(row_on_face(input_, face_rows_[midpoint.face],
                                       result_.mesh.positions[vertex_rows_.size()]));
  }
  for (const Index face : splits.cut_faces) {
    result_.face_is_new[face] = 1;
  }
  for (const Index face : splits.face_source) {
    result_.face_is_new.push_back(1);
    face_rows_.push_back(face_rows_[face]);
  }
}

void Assembler::set_columns() {
  result_.mesh.vertex_columns = input_.vertex_columns.blend(vertex_rows_);
  result_.mesh.face_columns = input_.face_columns.select(face_rows_);
  result_.source_face = std::move(face_rows_);
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
