/// Named attributes of the vertices or faces of a mesh, in the order of the file. Values are
/// doubles, which hold all PLY scalar types exactly; `type` is the type that is written.
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
  std::vector<double> values;             ///< one per row; of a list column all lists, end to end
  std::optional<Scalar> list_count_type;  ///< set for a list column
  std::vector<std::size_t> list_offsets;  ///< list columns: row r is [offsets[r], offsets[r + 1])
};

/// Columns that an operation changed because they describe the surface, which changed.
struct StaleColumns {
  bool new_normals = false;            ///< normals were computed again
  std::vector<std::string> dropped;    ///< names of dropped lists of texture coordinates
  bool dropped_source_points = false;  ///< carry.h
};

/// A new row as a weighted mean of up to three old ones. Unused sources have weight 0.
struct RowBlend {
  std::array<std::uint32_t, 3> source{};
  std::array<double, 3> weight{1, 0, 0};
};

struct Columns {
  std::vector<Column> columns;

  /// Returns the column of this name, or null.
  Column* find(std::string_view name);
  const Column* find(std::string_view name) const;
  /// Makes a column of `rows` zeros. It replaces a column of this name, else it is the last one.
  Column& get(std::string_view name, Scalar type, std::size_t rows);
  void erase(std::string_view name);
  /// Returns the given rows in that order; rows may repeat.
  Columns select(std::span<const std::uint32_t> rows) const;
  /// Interpolates floats and colors (red green blue alpha, rounded to their type). Other integers
  /// and lists take the row of largest weight.
  Columns blend(std::span<const RowBlend> rows) const;
  /// Appends a row that is blended from rows of these columns.
  void append(const RowBlend& row);
  /// Appends all `other_rows` rows of `other`. Missing values are zero or empty lists, and those of
  /// colors white. Returns the names of columns that are lists in one and numbers in the other.
  std::vector<std::string> concatenate(const Columns& other, std::size_t rows,
                                       std::size_t other_rows);
};

}  // namespace transformesh
