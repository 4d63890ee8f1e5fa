/// The grid of each vertex, to which repair after rounding moves the vertex (paper 4.3). Initially
/// the step of the grid is half the spacing of floating-point numbers at the largest coordinate of
/// the vertex. The step doubles each time a face at the vertex is broken. Thus only the
/// surroundings of broken faces move farther from round to round. Repair measures distances in
/// these steps. Reference: Halperin & Packer, "Iterated snap rounding", Computational Geometry
/// 23(2), 2002, where all vertices share one fixed grid. Cost: O(n) per call.
#pragma once

#include <cstdint>
#include <vector>

#include "clean/rounding/displacement.h"
#include "clean/stitch/assemble.h"

namespace transformesh {

class VertexGrids {
 public:
  /// Initializes all grid steps to half the spacing of numbers of `type` at the vertex.
  VertexGrids(const Assembly& assembly, Scalar type);

  Scalar type() const { return type_; }
  double step(const Mesh& mesh, Index vertex) const;
  /// Returns for each face the largest level of its corners. The level of a vertex is the number of
  /// times that its grid step was doubled.
  std::vector<std::uint8_t> levels_of_faces(const Mesh& mesh) const;
  std::uint8_t largest_level() const { return largest_level_; }

  /// Doubles the grid steps at the corners of the faces.
  void coarsen(const Mesh& mesh, const std::vector<Index>& faces);
  /// Moves vertices of the faces to the nearest points of their grids. Vertices whose grid step was
  /// not doubled stay. Moves vertices of the input only if `moves_input` is set. Returns true if a
  /// vertex moved; adds the displacement to `moved`.
  bool snap(Assembly& assembly, const std::vector<Index>& faces, bool moves_input,
            Displacement& moved) const;
  /// Transfers the grids of the vertices of `before`, the input of a clean pass, to its result
  /// `after`. A vertex that the clean pass created gets the coarsest grid of the input faces from
  /// which its faces are cut.
  void inherit(const Mesh& before, const Assembly& after);

 private:
  Scalar type_;
  /// For each vertex, the number of times that its grid step was doubled.
  std::vector<std::uint8_t> levels_;
  std::uint8_t largest_level_ = 0;
};

}  // namespace transformesh
