/// Checks whether a mesh is an oriented 2-manifold. On request also checks whether it is closed,
/// free of self-intersections, and the boundary of { p : w(p) >= winding level } of an original
/// mesh `certified`. The code that checks a property is independent of the operations that
/// establish it.
///
/// The winding number is tested at sample points in front of and behind faces. The winding number
/// of the mesh at a sample must be 1 if that of `certified` is >= winding level, and 0 otherwise. A
/// sample is undecided if rounding may have moved faces across it. If `certified` is open, its
/// winding numbers are not integers, and each face must be a piece of a face of `certified`.
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
  bool closed = false;                  ///< report a border as a problem
  bool intersections = false;           ///< report a self-intersection as a problem
  const Mesh* certified = nullptr;      ///< original mesh; also reports faces without area
  int winding_level = 1;                ///< winding level for `certified`; >= 1
  Scalar coordinate = Scalar::float64;  ///< the type in which positions were stored
};

struct Certificate {
  bool input_is_closed = false;  ///< `certified` is closed if equal positions are merged
  std::size_t samples = 0;       ///< samples with a definite result, right or wrong
  std::size_t undecided = 0;
  std::size_t wrong = 0;
  double margin = 0;    ///< bound on the undetected displacement of faces by rounding; input units
  std::string problem;  ///< the first wrong sample, or too many undecided samples; else empty

  double undecided_share() const;
  bool holds() const { return problem.empty(); }
};

struct MeshCheck {
  ManifoldReport manifold;
  std::size_t degenerate_faces = 0;  ///< faces without area
  std::size_t components = 0;
  long genus = 0;                                      ///< sum over all components
  std::optional<std::vector<FacePair>> intersections;  ///< intersecting pairs, if searched for
  std::optional<Certificate> certificate;              ///< set if `certified` was given
  /// Problems in this order: manifold, intersections, closedness, area, winding.
  std::vector<Problem> problems;
};

/// Checks a mesh. Throws UsageError for a winding level below 1.
MeshCheck check_mesh(const Mesh& mesh, const CheckMeshOptions& options = {},
                     const Progress& progress = Progress());

}  // namespace transformesh
