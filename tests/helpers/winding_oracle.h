/// Whether one mesh is the boundary of { p : w(p) >= winding level } of another, told by winding
/// numbers at sample points alone: w(output) must be 1 where w(input) >= winding level and 0
/// elsewhere. Shares nothing with the floor that computes such boundaries. Samples lie all over the
/// box, and close to faces of both meshes, in front of them and behind, where mistakes show.
/// Samples on or too near a surface are counted as undecided and not judged. Deterministic for a
/// seed.
#pragma once

#include <cstdint>
#include <string>

#include "mesh/mesh.h"

namespace transformesh::test {

struct WindingOracleOptions {
  int winding_level = 1;
  std::size_t samples = 2000;  ///< half in the box, half near faces
  std::uint64_t seed = 1;
  /// By how much the output may be off because its coordinates are rounded, as a fraction of the
  /// largest coordinate. Samples closer than that to a surface are undecided. 1e-6 suits float.
  double tolerance = 1e-9;
};

struct WindingOracleResult {
  std::size_t tested = 0;
  std::size_t wrong = 0;
  std::size_t undecided = 0;

  /// The first wrong sample.
  Vec3 wrong_point = Vec3::Zero();
  double wrong_input_winding = 0;
  double wrong_output_winding = 0;

  bool is_right() const { return wrong == 0 && undecided * 10 <= tested + undecided; }
};

WindingOracleResult compare_windings(const Mesh& input, const Mesh& output,
                                     const WindingOracleOptions& options = {});

/// `tested N wrong N undecided N`, and the first wrong sample if there is one.
std::string describe(const WindingOracleResult& result);

}  // namespace transformesh::test
