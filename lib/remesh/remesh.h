/// Keeps a surface well sampled while it evolves (paper 5.1.2): edges between two lengths, six at a
/// vertex, round triangles. Each iteration splits, collapses, flips and smooths, in the order of
/// Botsch & Kobbelt, "A remeshing approach to multiresolution modeling", SGP 2004.
///
/// Guarantees, for an oriented manifold with or without borders:
/// - the result is one too; genus and number of components change only by small components removed;
/// - no step adds a self-intersection or a face without area: splits, collapses, flips and moves
///   that would are refused (embedding_guard.h, safe_split.h). Intersections of the input stay;
/// - slivers, faces thinner than 4 spacings of their coordinates or than e1 / 100,000, are removed
///   first where that adds no intersection (slivers.h); the surface moves by their height;
/// - surviving vertices and faces keep their order, new ones follow; attributes are interpolated
///   for new and for sliding vertices, inherited by faces;
///   normals are computed anew, texture coordinates of corners dropped (surface_columns.h).
/// Not guaranteed: that all edges reach the interval; regular valences may take 1.12 e2.
/// Deterministic; O(n log n); about 150 bytes per face.
#pragma once

#include <string>

#include "geometry/keep_out_options.h"
#include "mesh/mesh.h"
#include "mesh/surface_columns.h"
#include "remesh/guards/edge_rules.h"
#include "support/progress.h"

namespace transformesh {

enum class Smoothing { none, tangential, laplace, bilaplace };

struct RemeshOptions {
  double min_edge = 0;  ///< e1: shorter edges are collapsed; input units, > 0
  double max_edge = 0;  ///< e2: longer edges are split; input units, >= 1.5 min_edge
  /// Where not empty: e1 and e2 are factors of this vertex column, as both ends' mean (sizing.h).
  std::string size_column;
  /// > 0: between e1 and e2, edges of 0.55 to 0.95 of what curvature takes to keep this near
  /// (sizing.h)
  double adaptive_error = 0;
  int iterations =
      1;  ///< >= 0; 0: only small components, degenerate faces; 3 or more: bilaplacian_smoothing.h
  bool only_smooth = false;  ///< no splits, collapses and flips
  FlipRule flip = FlipRule::valence;
  Smoothing smoothing = Smoothing::tangential;  ///< the Laplacians slide vertices as well
  double smooth_first = 0;                      ///< b of v - b dv, or b1; in [0, 1]
  double smooth_second = 0;  ///< b2 of v - b1 dv + b2 d2v; in [(b1 - 1) / 2, b1 / 2]
  /// Edges sharper than this stay; in [0, 180], 180: none are, 0: 40 if has_sharp_edges()
  /// (sharpness.h), else 180.
  double feature_angle_deg = 180;
  bool keep_border = false;  ///< leave border vertices and edges alone
  bool project = false;      ///< relaxed vertices end on the input; so with adaptive_error
  Scalar coordinate = Scalar::float64;  ///< new positions are rounded to this type, then checked
  KeepOutOptions keep_out = {};         ///< no step comes nearer to it than its gap (keep_out.h)
};

/// Components that were removed because they are too small (small_components.h).
struct RemovedComponents {
  std::size_t count = 0;
  std::size_t faces = 0;
  double area = 0;
  double volume = 0;  ///< sum of the absolute volumes
};

struct RemeshResult {
  std::size_t splits = 0;
  std::size_t collapses = 0;
  std::size_t flips = 0;
  std::size_t refused = 0;   ///< of the last iteration: steps wanted that would break a guarantee
  std::size_t kept_out = 0;  ///< steps refused because of `keep_out`
  std::size_t near_keep_out = 0;  ///< faces of the input nearer than its gap
  RemovedComponents components_removed;
  std::size_t degenerate_faces = 0;    ///< left: lower than a thousandth of their longest edges
  std::size_t slivers_kept = 0;        ///< of these: slivers (slivers.h)
  Vec3 first_sliver = Vec3::Zero();    ///< a corner of the first one
  std::size_t faces_without_area = 0;  ///< of these: input faces that nothing could remove
  double feature_angle_deg = 180;      ///< above which edges were kept
  StaleColumns columns;                ///< normals, and lists of texture coordinates
};

/// Throws UsageError for options out of range, InputError for what is no oriented manifold (with
/// face ids), has no faces or no sizes in the column or meets the surface to keep out of, GoalError
/// where nothing would be left. `opposites`: those of the halfedges (adjacency.h), if they are
/// known.
RemeshResult remesh(Mesh& mesh, const RemeshOptions& options, const Progress& progress = {},
                    std::vector<Index> opposites = {});

}  // namespace transformesh
