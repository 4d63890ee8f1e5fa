/// Tests whether an output mesh is the boundary of the region { p : w(p) >= winding level }, where
/// w is the winding number of an input mesh. Only sample points are tested: the winding number of
/// the output must be 1 if that of the input is at least the winding level, and 0 otherwise. Shares
/// no code with lib/clean, which computes such boundaries. Half of the samples lie in the bounding
/// box, half close to faces of both meshes, on both sides. Samples on or too close to a surface are
/// undecided. Deterministic for a seed.
#pragma once

#include <cstdint>
#include <string>

#include "transformesh/mesh.h"

namespace transformesh::test {

struct WindingOracleOptions {
  int winding_level = 1;
  /// Number of sample points; half in the bounding box, half near faces.
  std::size_t samples = 2000;
  std::uint64_t seed = 1;
  /// Allowed error of positions due to rounding, as a fraction of the largest coordinate. Samples
  /// closer to a surface are undecided. Use 1e-6 for floats.
  double tolerance = 1e-9;
};

struct WindingOracleResult {
  std::size_t tested = 0;
  std::size_t wrong = 0;
  std::size_t undecided = 0;

  /// The first wrong sample and its winding numbers.
  Vec3 wrong_point = Vec3::Zero();
  double wrong_input_winding = 0;
  double wrong_output_winding = 0;

  bool is_right() const { return wrong == 0 && undecided * 10 <= tested + undecided; }
};

/// Compares the winding numbers of both meshes.
WindingOracleResult compare_windings(const Mesh& input, const Mesh& output,
                                     const WindingOracleOptions& options = {});

/// Returns `tested N wrong N undecided N`, and the first wrong sample if there is one.
std::string describe(const WindingOracleResult& result);

}  // namespace transformesh::test
