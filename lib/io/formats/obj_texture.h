/// Collects the texture coordinates of an OBJ file, which corners reference by separate indices.
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
  /// Adds a texture coordinate. A non-finite texture coordinate counts as missing.
  void add_point(double u, double v) { points_.push_back({u, v}); }
  /// Adds the texture indices of a face. Indices start at 1, or are negative and relative to the
  /// last coordinate read; 0 means that a corner has none.
  void add_face(std::uint32_t row, std::span<const Index> corners,
                std::span<const std::int64_t> numbers);
  /// True if any face has texture indices.
  bool is_used() const { return !offsets_.empty(); }
  /// Adds columns as described in obj.h. The faces of the mesh must still be the rows of the file.
  void move_into(Mesh& mesh, std::uint32_t rows, std::vector<std::string>& notes);

 private:
  bool are_of_vertices(std::size_t vertices, std::uint32_t rows) const;
  bool is_there(Index point) const;
  Scalar type() const;
  void add_vertex_columns(Mesh& mesh) const;
  std::size_t add_lists(Mesh& mesh, std::uint32_t rows) const;

  std::vector<std::array<double, 2>> points_;
  std::vector<Index> corners_;
  /// Start of each face in `corners_`, from the first textured face on.
  std::vector<std::size_t> offsets_;
  bool has_numbers_of_vertices_ = true;
};

}  // namespace transformesh
