/// Gathers the texture coordinates of an OBJ file, which corners name by numbers of their own.
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
  /// One that is not finite is taken as one that is not there.
  void add_point(double u, double v) { points_.push_back({u, v}); }
  /// For each corner of a face the number in the file, from 1 on, or negative and counted back from
  /// the last read; 0 for none.
  void add_face(std::uint32_t row, std::span<const Index> corners,
                std::span<const std::int64_t> numbers);
  /// Whether a face names any.
  bool is_used() const { return !offsets_.empty(); }
  /// Adds columns to a mesh whose faces are still the rows: see obj.h.
  void move_into(Mesh& mesh, std::uint32_t rows, std::vector<std::string>& notes);

 private:
  bool are_of_vertices(std::size_t vertices, std::uint32_t rows) const;
  bool is_there(Index point) const;
  Scalar type() const;
  void add_vertex_columns(Mesh& mesh) const;
  std::size_t add_lists(Mesh& mesh, std::uint32_t rows) const;

  std::vector<std::array<double, 2>> points_;
  std::vector<Index> corners_;
  std::vector<std::size_t> offsets_;  ///< from the first face on that names some
  bool has_numbers_of_vertices_ = true;
};

}  // namespace transformesh
