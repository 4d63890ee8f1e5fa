/// Collapses a single edge if the rules of collapse.h allow it.
#pragma once

#include <vector>

#include "remesh/guards/edge_rules.h"
#include "remesh/guards/embedding_guard.h"
#include "remesh/guards/error_bound.h"
#include "remesh/halfedges/vertex_role.h"

namespace transformesh {

class EdgeCollapser {
 public:
  /// If `bound` is not null, collapses also keep this error bound.
  EdgeCollapser(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
                double max_edge, ErrorBound* bound = nullptr)
      : mesh_(mesh), guard_(&guard), bound_(bound), roles_(roles), longest_(max_edge * max_edge) {}
  /// Works without a guard; the caller must check for intersections.
  EdgeCollapser(EditableMesh& mesh, const VertexRoles& roles, double max_edge)
      : mesh_(mesh),
        guard_(nullptr),
        bound_(nullptr),
        roles_(roles),
        longest_(max_edge * max_edge) {}

  /// Returns the merged vertex; no_index if the edge stays.
  Index collapse(Index halfedge);
  /// Collapses an edge to the given position only, and allows narrower triangles. If the role of
  /// one end is stricter than that of the other, the position must be that of this end.
  Index collapse_to(Index halfedge, const Vec3& position);
  /// Sets the rules for the shape; by default all are off. Call before the first collapse.
  void keep_shape(const ShapeRules& rules) { shape_ = rules; }
  /// Returns the number of collapses that were refused only because of ShapeRules::min_film.
  std::size_t films_kept() const { return films_kept_; }
  /// True if the last position was refused because an edge would be too long.
  bool was_too_long() const { return was_too_long_; }

 private:
  /// A triangle that remains after the collapse, given without its corner at the edge.
  struct Spoke {
    Vec3 first;
    Vec3 second;
    Vec3 normal;
    bool has_normal;
    double first_limit;  ///< squared length limit of the new edge to `first`
    double second_limit;
  };

  /// Distances of a position from the planes of the faces that are replaced.
  struct SurfaceShift {
    double quadric = 0;  ///< sum of the squared distances, weighted by twice the area
    double most = 0;     ///< largest distance from one of the planes
  };

  bool prepare(Index halfedge);
  bool try_bound_end();
  void gather();
  void gather_star(Index vertex);
  double longest_to(Index neighbor) const;
  bool try_position(const Vec3& wanted, double source_share);
  bool try_free_positions();
  bool try_curved_positions();
  SurfaceShift shift_to(const Vec3& position) const;
  bool moves_too_far(const Vec3& position) const;
  Vec3 volume_keeping_shift(const Vec3& position) const;
  bool is_sound(const Vec3& position);
  double least_roundness_before() const;
  void fill_patch(const Vec3& position);

  EditableMesh& mesh_;
  EmbeddingGuard* guard_;
  ErrorBound* bound_;
  const VertexRoles& roles_;
  double longest_;
  ShapeRules shape_;
  std::size_t films_kept_ = 0;
  bool met_film_ = false;
  double round_enough_ = 0;
  double normal_roundness_ = 0;
  bool was_too_long_ = false;
  Index edge_ = no_index;
  Index goes_ = no_index;
  Index stays_ = no_index;
  std::vector<Spoke> spokes_;
  Vec3 mean_normal_ = Vec3::Zero();
  double volume_ = 0;  ///< six times the volume between the star of goes_ and stays_
  Patch patch_;
};

}  // namespace transformesh
