/// The grid of every vertex (paper 4.3). At first its step is half the spacing of numbers at the
/// largest coordinate of the vertex, which any stored position has. It doubles whenever a face at
/// the vertex is broken, so that only what lies at broken faces moves farther from round to round.
/// Repair counts its distances in these steps. Reference: Halperin & Packer, "Iterated snap
/// rounding", Computational Geometry 23(2), 2002, where all vertices have one grid, which stays.
#pragma once

#include <cstdint>
#include <vector>

#include "clean/rounding/displacement.h"
#include "clean/stitch/assemble.h"

namespace transformesh {

class VertexGrids {
 public:
  /// All steps are half a spacing.
  VertexGrids(const Assembly& assembly, Scalar type);

  Scalar type() const { return type_; }
  double step(const Mesh& mesh, Index vertex) const;
  /// Doublings of steps, per face: the most at a corner.
  std::vector<std::uint8_t> levels_of_faces(const Mesh& mesh) const;
  std::uint8_t largest_level() const { return largest_level_; }

  /// Doubles the steps at the corners of these faces.
  void coarsen(const Mesh& mesh, const std::vector<Index>& faces);
  /// Moves vertices of the faces to their grids where these are coarser than at first; those of
  /// the input only if they may. Returns whether one moved, and notes how far.
  bool snap(Assembly& assembly, const std::vector<Index>& faces, bool moves_input,
            Displacement& moved) const;
  /// Takes over the grids of `before` for the result of cleaning it: new vertices take the
  /// coarsest grid of the faces of which they bound a piece.
  void inherit(const Mesh& before, const Assembly& after);

 private:
  Scalar type_;
  std::vector<std::uint8_t> levels_;  ///< per vertex: doublings
  std::uint8_t largest_level_ = 0;
};

}  // namespace transformesh
