/// Whether a mesh is an oriented 2-manifold and, on request, closed, free of self-intersections,
/// and the boundary of { p : w(p) >= winding level } of another mesh. Each property is checked by
/// code that shares nothing with the operations that establish it. Cost: O(n) for the manifold,
/// that of find_intersections() and of certify() if wanted. Deterministic for any number of
/// threads.
#pragma once

#include <optional>
#include <vector>

#include "transformesh/certify.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"

namespace transformesh {

struct CheckMeshOptions {
  bool closed = false;                  ///< a border is a problem
  bool intersections = false;           ///< a self-intersection is a problem
  const Mesh* certified = nullptr;      ///< the other mesh; a face without area is a problem, too
  int winding_level = 1;                ///< of `certified`; >= 1
  Scalar coordinate = Scalar::float64;  ///< the type in which positions were stored
};

struct MeshCheck {
  ManifoldReport manifold;
  std::size_t degenerate_faces = 0;  ///< faces without area
  std::size_t components = 0;
  long genus = 0;                                      ///< of all components
  std::optional<std::vector<FacePair>> intersections;  ///< if they were searched for
  std::optional<Certificate> certificate;              ///< if there was another mesh
  std::vector<Problem> problems;  ///< in order: manifold, intersections, closedness, area, winding
};

/// Checks a mesh. Throws UsageError for a winding level below 1.
MeshCheck check_mesh(const Mesh& mesh, const CheckMeshOptions& options = {},
                     const Progress& progress = Progress());

}  // namespace transformesh
