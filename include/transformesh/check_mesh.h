/// Checks whether a mesh is an oriented 2-manifold and, on request, closed, free of
/// self-intersections, and the boundary of { p : w(p) >= winding level } of another mesh. Each
/// property is checked by code that shares nothing with the operations that establish it.
///
/// The last property is tested at sample points in front of and behind faces. The winding number of
/// the mesh at a sample must be 1 if that of the other mesh is >= winding level, and 0 if it is
/// not. A sample is undecided if rounding may have moved faces over it. If the other mesh is open,
/// its winding numbers are no integers; then each new face must be a piece of one of its faces.
///
/// Cost: O(n) for the manifold, that of find_intersections(), and O(log n) per sample on usual
/// meshes. Deterministic for any number of threads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "transformesh/intersect.h"
#include "transformesh/manifold.h"

namespace transformesh {

struct CheckMeshOptions {
  bool closed = false;                  ///< a border is a problem
  bool intersections = false;           ///< a self-intersection is a problem
  const Mesh* certified = nullptr;      ///< the other mesh; a face without area is a problem, too
  int winding_level = 1;                ///< level of `certified`; >= 1
  Scalar coordinate = Scalar::float64;  ///< the type in which positions were stored
};

struct Certificate {
  bool input_is_closed = false;  ///< if equal positions are joined
  std::size_t samples = 0;       ///< samples that were decided, wrong ones included
  std::size_t undecided = 0;
  std::size_t wrong = 0;
  double margin = 0;    ///< the farthest that rounding may have moved a new face unnoticed
  std::string problem;  ///< the first wrong sample, or too many undecided ones; empty if none

  double undecided_share() const;
  bool holds() const { return problem.empty(); }
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
