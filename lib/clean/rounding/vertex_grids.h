/// The grid of each vertex (paper 4.3). Initially its step is half the spacing of numbers at the
/// largest coordinate of the vertex; every stored position is on this grid. The step doubles each
/// time a face at the vertex is broken. Thus only the surroundings of broken faces move farther
/// from round to round. Repair measures distances in these steps. Reference: Halperin & Packer,
/// "Iterated snap rounding", Computational Geometry 23(2), 2002, where all vertices share one fixed
/// grid. Cost: O(n) per call.
#pragma once

#include <cstdint>
#include <vector>

#include "clean/rounding/displacement.h"
#include "clean/stitch/assemble.h"

namespace transformesh {

class VertexGrids {
 public:
  /// Initializes all steps to half a spacing.
  VertexGrids(const Assembly& assembly, Scalar type);

  Scalar type() const { return type_; }
  double step(const Mesh& mesh, Index vertex) const;
  /// Returns for each face the largest number of doublings at its corners.
  std::vector<std::uint8_t> levels_of_faces(const Mesh& mesh) const;
  std::uint8_t largest_level() const { return largest_level_; }

  /// Doubles the steps at the corners of the faces.
  void coarsen(const Mesh& mesh, const std::vector<Index>& faces);
  /// Moves vertices of the faces to their grids if these are coarser than initially. Moves vertices
  /// of the input only if `moves_input` is set. Returns true if a vertex moved; adds the
  /// displacement to `moved`.
  bool snap(Assembly& assembly, const std::vector<Index>& faces, bool moves_input,
            Displacement& moved) const;
  /// Transfers the grids of `before` to the result of a clean pass. A new vertex takes the coarsest
  /// grid of the faces whose pieces it bounds.
  void inherit(const Mesh& before, const Assembly& after);

 private:
  Scalar type_;
  std::vector<std::uint8_t> levels_;  ///< number of doublings of each vertex's step
  std::uint8_t largest_level_ = 0;
};

}  // namespace transformesh
