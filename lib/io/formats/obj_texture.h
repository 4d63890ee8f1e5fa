/// Collects the texture coordinates of an OBJ file. Corners of faces refer to them by indices of
/// their own.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

class ObjTexture {
 public:
  /// Adds a texture coordinate. If u or v is not finite, the texture coordinate counts as missing.
  void add_point(double u, double v) { points_.push_back({u, v}); }
  /// Adds the indices of texture coordinates at the corners of a face. Indices start at 1. Negative
  /// indices are relative to the last texture coordinate read, and 0 means that a corner has none.
  void add_face(std::uint32_t row, std::span<const Index> corners,
                std::span<const std::int64_t> numbers);
  /// True if any face has texture coordinates.
  bool is_used() const { return !offsets_.empty(); }
  /// Adds the columns `texcoord`, or s and t, as described in obj.h. The faces of the mesh must
  /// still be those of the file, before triangulation.
  void move_into(Mesh& mesh, std::uint32_t rows, std::vector<std::string>& notes);

 private:
  bool are_of_vertices(std::size_t vertices, std::uint32_t rows) const;
  bool is_there(Index point) const;
  Scalar type() const;
  void add_vertex_columns(Mesh& mesh) const;
  std::size_t add_lists(Mesh& mesh, std::uint32_t rows) const;

  std::vector<std::array<double, 2>> points_;
  std::vector<Index> corners_;
  /// For each face, the index in `corners_` at which its corners start, and after these the end of
  /// the last face. Empty until a face has texture coordinates.
  std::vector<std::size_t> offsets_;
  bool has_numbers_of_vertices_ = true;
};

}  // namespace transformesh
