/// Named attributes of the vertices or faces of a mesh, in the order of the file. Values are stored
/// as doubles, which represent all PLY scalar types exactly; `type` is the type in the file.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace transformesh {

enum class Scalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Column {
  std::string name;
  Scalar type = Scalar::float32;
  std::vector<double> values;             ///< one per row; list columns: all lists, concatenated
  std::optional<Scalar> list_count_type;  ///< set for a list column
  std::vector<std::size_t> list_offsets;  ///< list columns: row r is [offsets[r], offsets[r + 1])
};

/// Columns that an operation recomputed or dropped because the surface changed.
struct StaleColumns {
  bool new_normals = false;            ///< normals were recomputed
  std::vector<std::string> dropped;    ///< names of dropped lists of texture coordinates
  bool dropped_source_points = false;  ///< source points were dropped (carry.h)
};

/// A new row as a weighted mean of up to three old rows. Unused entries have weight 0.
struct RowBlend {
  std::array<std::uint32_t, 3> source{};
  std::array<double, 3> weight{1, 0, 0};
};

struct Columns {
  std::vector<Column> columns;

  /// Returns the column of this name, or null.
  Column* find(std::string_view name);
  const Column* find(std::string_view name) const;
  /// Creates a column of `rows` zeros. Replaces a column of this name; otherwise appends it.
  Column& get(std::string_view name, Scalar type, std::size_t rows);
  void erase(std::string_view name);
  /// Returns the given rows in that order; rows may repeat.
  Columns select(std::span<const std::uint32_t> rows) const;
  /// Interpolates floats and colors (red green blue alpha, rounded to their type). Other integers
  /// and lists take the row with the largest weight.
  Columns blend(std::span<const RowBlend> rows) const;
  /// Appends a row that is interpolated from rows of these columns.
  void append(const RowBlend& row);
  /// Appends the `other_rows` rows of `other`. Missing values become zero, white or empty lists;
  /// colors get one scale. Returns names of columns that are lists in one and numbers in the other.
  std::vector<std::string> concatenate(const Columns& other, std::size_t rows,
                                       std::size_t other_rows);
};

}  // namespace transformesh
