/// Fewer faces: collapses the edges whose collapse changes the surface least, by the squared
/// distances from the planes of the input's faces, until as many faces are left as are wanted. An
/// edge becomes the point of the least sum, its middle or one of its ends. Reference: Garland &
/// Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH 1997; every collapse
/// keeps what remesh.h promises: the topology, an embedding without self-intersections
/// (embedding_guard.h), attributes blended. Deterministic; O(n log n) for n faces; about 300 bytes
/// per face.
#pragma once

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct DecimateOptions {
  std::size_t faces = 0;           ///< wanted; >= 4
  double feature_angle_deg = 180;  ///< edges sharper than this stay; in (0, 180], 180: none are
  bool keep_border = false;        ///< leave border vertices and edges alone
  Scalar coordinate = Scalar::float64;  ///< new positions are rounded to this type, then checked
  KeepOutOptions keep_out = {};         ///< no collapse comes nearer to it than its gap
};

struct DecimateResult {
  std::size_t collapses = 0;
  std::size_t faces = 0;          ///< left: those wanted or one less; all where there were no more
  std::size_t kept_out = 0;       ///< collapses refused because of `keep_out`
  std::size_t near_keep_out = 0;  ///< faces of the input nearer than its gap
  StaleColumns columns;           ///< normals, and lists of texture coordinates, as of remesh()
};

/// Throws UsageError for options out of range, and InputError if the mesh is no oriented manifold
/// or has no faces. Throws GoalError if more than 1.01 `faces` are left because every further
/// collapse would change the topology or make a self-intersection.
DecimateResult decimate(Mesh& mesh, const DecimateOptions& options, const Progress& progress = {});

}  // namespace transformesh
