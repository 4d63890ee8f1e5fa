/// The triangle mesh that remeshing edits in place: an index-based halfedge structure for oriented
/// manifolds with or without borders. Halfedge 3 * face + corner is defined as in mesh.h, so that
/// next and previous are arithmetic, and only `opposite` is stored. A removed face or vertex leaves
/// a dead slot, and new ones are appended. Remaining elements thus keep their order; to_mesh()
/// removes dead slots. Every vertex and face has the index of its row of attributes.
#pragma once

#include <span>
#include <vector>

#include "mesh/coordinate_spacing.h"
#include "mesh/triangle.h"

namespace transformesh {

class EditableMesh {
 public:
  /// Throws InputError with face indices if the mesh is not an oriented manifold. Reasons are an
  /// index out of range, a face with a repeated corner, and an edge of three faces. Also throws if
  /// two faces traverse an edge in the same direction, or if a vertex has several umbrellas. O(n).
  explicit EditableMesh(const Mesh& mesh);
  /// The same for a mesh whose manifold_opposites() (halfedges.h) are known.
  EditableMesh(const Mesh& mesh, std::vector<Index> opposites);
  /// Returns the living vertices and faces in slot order: first those of the input, then new ones.
  Mesh to_mesh() const;

  Index vertex_slots() const { return static_cast<Index>(positions_.size()); }
  Index face_slots() const { return static_cast<Index>(sources_.size() / 3); }
  Index halfedge_slots() const { return static_cast<Index>(sources_.size()); }
  bool has_vertex(Index vertex) const { return outgoing_[vertex] != no_index; }
  bool has_face(Index face) const { return sources_[std::size_t{3} * face] != no_index; }
  bool has_halfedge(Index halfedge) const { return sources_[halfedge] != no_index; }
  bool has_borders() const { return has_borders_; }

  Index source(Index halfedge) const { return sources_[halfedge]; }
  Index target(Index halfedge) const { return sources_[next_halfedge(halfedge)]; }
  Index apex(Index halfedge) const { return sources_[previous_halfedge(halfedge)]; }
  Index opposite(Index halfedge) const { return opposites_[halfedge]; }
  /// True for one halfedge of each edge: the one with the lower index, or the only one.
  bool is_edge(Index halfedge) const {
    return has_halfedge(halfedge) && halfedge < opposites_[halfedge];
  }
  bool is_border(Index halfedge) const { return opposites_[halfedge] == no_index; }
  /// Returns the first outgoing halfedge in counter-clockwise order. At a border vertex it is on
  /// the border.
  Index outgoing(Index vertex) const { return outgoing_[vertex]; }
  bool is_border_vertex(Index vertex) const { return is_border(outgoing_[vertex]); }

  const Vec3& position(Index vertex) const { return positions_[vertex]; }
  double squared_length(Index halfedge) const {
    return (positions_[target(halfedge)] - positions_[source(halfedge)]).squaredNorm();
  }
  /// Returns the squared length in units of the mean size of both ends; unscaled if there are no
  /// sizes.
  double scaled_squared_length(Index halfedge) const {
    const double squared = squared_length(halfedge);
    if (sizes_.empty()) return squared;
    const double size = mean_size(source(halfedge), target(halfedge));
    return squared / (size * size);
  }
  /// Returns scaled_squared_length() of the three halfedges of a face.
  std::array<double, 3> scaled_squared_lengths(Index face) const {
    const Index* corners = sources_.data() + std::size_t{3} * face;
    const Vec3& a = positions_[corners[0]];
    const Vec3& b = positions_[corners[1]];
    const Vec3& c = positions_[corners[2]];
    std::array<double, 3> result{(b - a).squaredNorm(), (c - b).squaredNorm(),
                                 (a - c).squaredNorm()};
    if (sizes_.empty()) return result;
    for (std::size_t i = 0; i < 3; ++i) {
      const double size = mean_size(corners[i], corners[(i + 1) % 3]);
      result[i] /= size * size;
    }
    return result;
  }
  Triangle triangle(Index face) const {
    const Index* corners = sources_.data() + std::size_t{3} * face;
    return triangle_of(positions_, {corners[0], corners[1], corners[2]});
  }
  /// Returns twice the area times the unit normal.
  Vec3 face_normal(Index face) const;

  /// Calls visit(halfedge) for every halfedge that leaves the vertex, counter-clockwise, one per
  /// face at the vertex.
  template <class Visit>
  void for_each_outgoing(Index vertex, const Visit& visit) const {
    const Index first = outgoing_[vertex];
    Index halfedge = first;
    do {
      visit(halfedge);
      halfedge = opposites_[previous_halfedge(halfedge)];
    } while (halfedge != first && halfedge != no_index);
  }
  /// Calls visit(neighbor, halfedge) for every edge at the vertex. The halfedge leaves the vertex,
  /// except at the last edge of a border vertex, where it arrives.
  template <class Visit>
  void for_each_neighbor(Index vertex, const Visit& visit) const {
    Index last = no_index;
    for_each_outgoing(vertex, [&](Index halfedge) {
      visit(target(halfedge), halfedge);
      last = previous_halfedge(halfedge);
    });
    if (opposites_[last] == no_index) visit(sources_[last], last);
  }
  Index valence(Index vertex) const;
  bool are_neighbors(Index first, Index second) const;

  /// Marks an edge as a feature, which is kept sharp. Splits and collapses propagate the mark.
  void set_feature(Index halfedge, bool is_feature);
  void clear_features() { features_.clear(); }
  bool has_features() const { return !features_.empty(); }
  bool is_feature(Index halfedge) const { return !features_.empty() && features_[halfedge]; }

  /// Sets a wanted edge length per vertex. The operations interpolate it like attributes.
  void set_sizes(std::vector<double> sizes) { sizes_ = std::move(sizes); }
  bool has_sizes() const { return !sizes_.empty(); }
  double mean_size(Index first, Index second) const {
    return sizes_.empty() ? 1 : 0.5 * (sizes_[first] + sizes_[second]);
  }
  double size(Index vertex) const { return sizes_.empty() ? 1 : sizes_[vertex]; }

  /// Sets a label per vertex, equal within a component. The operations neither join nor separate
  /// components. components() is empty if no labels are set.
  void set_components(std::vector<Index> components) { components_ = std::move(components); }
  std::span<const Index> components() const { return components_; }

  /// Sets the type to which rounded() rounds new positions, so that checks use the coordinates that
  /// a file of this type will contain.
  void set_coordinate(Scalar coordinate) { single_ = coordinate == Scalar::float32; }
  Scalar coordinate() const { return single_ ? Scalar::float32 : Scalar::float64; }
  Vec3 rounded(const Vec3& position) const {
    if (!single_) return position;
    return {round_to_single(position.x()), round_to_single(position.y()),
            round_to_single(position.z())};
  }
  /// Moves a vertex. Positions passed to this and the following functions must already be rounded.
  void move(Index vertex, const Vec3& position) { positions_[vertex] = position; }
  /// Splits an edge and returns the new vertex, which has the mean attributes of both ends. New
  /// faces have the attributes of the faces that were split.
  Index split(Index halfedge, const Vec3& position);
  /// True if merging the ends of the edge leaves a manifold of the same topology (link condition).
  bool can_collapse(Index halfedge) const;
  /// Merges the source of the halfedge into its target, which moves to `position`. The attributes
  /// of the source have the weight `source_weight`, in [0, 1]. Pre: can_collapse.
  void collapse(Index halfedge, const Vec3& position, double source_weight);
  /// True if the edge has two faces, and the flipped edge does not exist yet.
  bool can_flip(Index halfedge) const;
  /// Exchanges the diagonal of the two faces. Pre: can_flip.
  void flip(Index halfedge);
  /// Copies the attributes of the face `from` to the face `to`.
  void copy_face_row(Index from, Index to) { face_rows_[to] = face_rows_[from]; }
  /// Removes a face without updating its neighbors; for removing whole components.
  void remove_face(Index face);
  void remove_vertex(Index vertex) { outgoing_[vertex] = no_index; }

  bool has_vertex_attributes() const { return !vertex_columns_.columns.empty() || !sizes_.empty(); }
  /// Sets the attributes and the size of a vertex to the weighted mean of those of three vertices.
  void blend_attributes(Index vertex, const std::array<Index, 3>& sources,
                        const std::array<double, 3>& weights);

 private:
  bool has_three_neighbors(Index vertex) const;
  Index count_common_neighbors(Index from, Index to) const;
  void link(Index first, Index second);
  void find_outgoing();
  Index append_face(Index a, Index b, Index c, Index row);
  Index append_row(const RowBlend& blend);
  void set_opposite(Index halfedge, Index opposite);
  void copy_feature(Index from, Index to);
  void close_gap(Index removed, Index other_removed);
  void rewind_outgoing(Index vertex, Index any_outgoing);
  std::vector<Index> squeezed_vertices(std::vector<Index>& new_index) const;

  std::vector<Vec3> positions_;
  std::vector<Index> sources_;     ///< per halfedge; no_index in dead faces
  std::vector<Index> opposites_;   ///< per halfedge
  std::vector<Index> outgoing_;    ///< per vertex; no_index for dead and isolated ones
  std::vector<bool> isolated_;     ///< vertices without a face in the input, which are kept
  std::vector<char> features_;     ///< per halfedge; empty if there are no features
  std::vector<double> sizes_;      ///< per vertex; empty if there are no sizes
  std::vector<Index> components_;  ///< per vertex, or empty
  std::vector<Index> vertex_rows_;
  std::vector<Index> face_rows_;
  Columns vertex_columns_;
  Columns face_columns_;
  Index vertex_row_count_ = 0;
  bool has_borders_ = false;
  bool single_ = false;
};

}  // namespace transformesh
