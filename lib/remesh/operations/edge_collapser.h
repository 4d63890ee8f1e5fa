/// Collapses one edge where that keeps what collapse.h promises.
#pragma once

#include <vector>

#include "remesh/guards/edge_rules.h"
#include "remesh/guards/embedding_guard.h"
#include "remesh/guards/error_bound.h"
#include "remesh/halfedges/vertex_role.h"

namespace transformesh {

class EdgeCollapser {
 public:
  /// Positions keep the bound, if there is one.
  EdgeCollapser(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
                double max_edge, ErrorBound* bound = nullptr)
      : mesh_(mesh), guard_(&guard), bound_(bound), roles_(roles), longest_(max_edge * max_edge) {}
  /// Without a guard: the caller looks for intersections.
  EdgeCollapser(EditableMesh& mesh, const VertexRoles& roles, double max_edge)
      : mesh_(mesh),
        guard_(nullptr),
        bound_(nullptr),
        roles_(roles),
        longest_(max_edge * max_edge) {}

  /// The vertex that the edge became; no_index where it stays.
  Index collapse(Index halfedge);
  /// The same, to that position only, and with narrower triangles. If one end is bound more than
  /// the other, the position has to be its own.
  Index collapse_to(Index halfedge, const Vec3& position);
  /// To be called before the first collapse; without that, all of the rules are off.
  void keep_shape(const ShapeRules& rules) { shape_ = rules; }
  /// How many collapses stayed undone though all but the rule on films allowed them.
  std::size_t films_kept() const { return films_kept_; }
  /// Whether the last position was refused because an edge would be too long.
  bool was_too_long() const { return was_too_long_; }

 private:
  /// A triangle that stays, without its corner at the edge.
  struct Spoke {
    Vec3 first;
    Vec3 second;
    Vec3 normal;
    bool has_normal;
    double first_limit;  ///< squared: no new edge to `first` may be longer
    double second_limit;
  };

  /// How far the planes of the faces that give way are from a position.
  struct SurfaceShift {
    double quadric = 0;  ///< sum of the squares, weighted by twice the area
    double most = 0;
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
  bool was_too_long_ = false;
  Index edge_ = no_index;
  Index goes_ = no_index;
  Index stays_ = no_index;
  std::vector<Spoke> spokes_;
  Vec3 mean_normal_ = Vec3::Zero();
  double volume_ = 0;  ///< six times what the star of goes_ encloses with stays_
  Patch patch_;
};

}  // namespace transformesh
