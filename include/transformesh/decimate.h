/// Decimation: collapses the edges that change the surface least until the wanted number of faces
/// is left, or until each further collapse would exceed a maximal distance, `error`. The cost is
/// the sum of squared distances from the planes of the input's faces. An edge is collapsed to the
/// point of least cost, to its midpoint or to one of its ends. Reference: Garland & Heckbert,
/// "Surface simplification using quadric error metrics", SIGGRAPH 1997.
///
/// Guarantees, as for remesh(): the topology stays, no self-intersection is added
/// (embedding_guard.h), and attributes are interpolated. If `error` is set, each point of the input
/// is within this distance of the result and vice versa (error_bound.h), and flat faces are merged
/// first (merge_flat.h). If `error` is not set, flat faces are merged only if collapses alone do
/// not reach `faces`. Deterministic; O(n log n) for n faces; about 300 bytes per face, 550 if
/// `error` is set.
#pragma once

#include <optional>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct DecimateOptions {
  /// Wanted number of faces, >= 4. If 0, `error` must be set: as few faces as `error` allows.
  std::size_t faces = 0;
  /// Edges sharper than this angle are kept; in (0, 180]; 180: no edge is sharp.
  double feature_angle_deg = 180;
  bool keep_border = false;             ///< keep border vertices and edges
  Scalar coordinate = Scalar::float64;  ///< new positions are rounded to this type, then checked
  KeepOutOptions keep_out = {};  ///< an obstacle, and the distance that collapses keep from it
  /// Largest distance between input and result in both directions; input units; >= 0. With 0, only
  /// flat faces are merged, which moves the surface by rounding errors.
  std::optional<double> error = {};
};

struct DecimateResult {
  std::size_t collapses = 0;
  /// Faces of the result: the wanted number or one less, or all if the input has fewer. Merging of
  /// flat faces alone may leave fewer.
  std::size_t faces = 0;
  std::size_t merged_faces = 0;   ///< faces removed by merging flat faces
  std::size_t error_refused = 0;  ///< collapses refused because of `error`; each attempt counts
  double error_bound = 0;    ///< bound on the distance between both surfaces; 0 without `error`
  std::size_t kept_out = 0;  ///< collapses refused because of `keep_out`
  std::size_t near_keep_out = 0;  ///< input faces that are nearer to `keep_out` than its gap
  StaleColumns columns;           ///< normals and texture coordinates are treated as in remesh()
};

/// Throws UsageError for options out of range, and InputError if the mesh is no oriented manifold
/// or has no faces. Throws GoalError if there is no `error` and more than 1.01 times `faces` are
/// left because every further collapse would change the topology or make a self-intersection.
DecimateResult decimate(Mesh& mesh, const DecimateOptions& options, const Progress& progress = {});

}  // namespace transformesh
