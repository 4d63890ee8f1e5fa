/// Fewer faces: collapses the edges whose collapse changes the surface least, by the squared
/// distances from the planes of the input's faces, until as many faces are left as are wanted, or
/// until each further collapse would exceed an error. An edge becomes the point of the least sum,
/// its middle or one of its ends. Reference: Garland & Heckbert, "Surface simplification using
/// quadric error metrics", SIGGRAPH 1997; every collapse keeps what remesh.h promises: the
/// topology, an embedding without self-intersections (embedding_guard.h), attributes blended. With
/// an error, each point of the input is within it of the result and vice versa (error_bound.h), and
/// flat faces are merged first (merge_flat.h). Deterministic; O(n log n) for n faces; about 300
/// bytes per face, 550 with an error.
#pragma once

#include <optional>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct DecimateOptions {
  std::size_t faces = 0;           ///< wanted; >= 4, or with an error 0: as few as that allows
  double feature_angle_deg = 180;  ///< edges sharper than this stay; in (0, 180], 180: none are
  bool keep_border = false;        ///< leave border vertices and edges alone
  Scalar coordinate = Scalar::float64;  ///< new positions are rounded to this type, then checked
  KeepOutOptions keep_out = {};         ///< no collapse comes nearer to it than its gap
  /// Largest distance of the input and the result in both directions; >= 0. With 0, flat faces are
  /// merged, which moves the surface by rounding errors, and nothing else is done.
  std::optional<double> error = {};
};

struct DecimateResult {
  std::size_t collapses = 0;
  /// Left: those wanted or one less; all if there were no more. Merging alone may leave fewer.
  std::size_t faces = 0;
  std::size_t merged_faces = 0;   ///< faces that merging flat ones removed
  std::size_t error_refused = 0;  ///< collapses refused because of `error`, tried again or not
  double error_bound = 0;         ///< the surfaces are within this of each other; 0 without `error`
  std::size_t kept_out = 0;       ///< collapses refused because of `keep_out`
  std::size_t near_keep_out = 0;  ///< faces of the input nearer than its gap
  StaleColumns columns;           ///< normals, and lists of texture coordinates, as of remesh()
};

/// Throws UsageError for options out of range, and InputError if the mesh is no oriented manifold
/// or has no faces. Throws GoalError if there is no `error` and more than 1.01 `faces` are left
/// because every further collapse would change the topology or make a self-intersection.
DecimateResult decimate(Mesh& mesh, const DecimateOptions& options, const Progress& progress = {});

}  // namespace transformesh
