/// Named attribute columns of the vertices or the faces of a mesh, in the order of the file. All
/// PLY scalar types fit a double exactly, so values are doubles; `type` says how they are written.
/// Operations that make new elements carry the columns by saying where each new row comes from.
#pragma once

#include <array>
#include <cstddef>
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

/// A new row as a weighted mean of up to three old ones. Unused sources have weight 0.
struct RowBlend {
  std::array<std::uint32_t, 3> source{};
  std::array<double, 3> weight{1, 0, 0};
};

class Columns {
 public:
  std::vector<Column> columns;

  Column* find(std::string_view name);
  const Column* find(std::string_view name) const;
  /// A column of `rows` zeros, for results: in the place of one that has this name already,
  /// whatever that holds, else behind the others, which may move them in memory.
  Column& get(std::string_view name, Scalar type, std::size_t rows);
  void erase(std::string_view name);

  /// The rows named, in that order; rows may repeat.
  Columns select(std::span<const std::uint32_t> rows) const;
  /// Float columns are interpolated, colors (red green blue alpha) too and rounded to their type;
  /// other integer columns and lists take the row of largest weight (the first of equals).
  Columns blend(std::span<const RowBlend> rows) const;
  /// Appends `row` of this table blended as above: for operations that work in place.
  void append(const RowBlend& row);
  /// Appends all rows of `other` (which has `other_rows`); missing values are zero, empty for
  /// lists. Types become as wide as both tables need. Returns the names of columns that are lists
  /// in one table and numbers in the other: their values in `other` are missing too.
  std::vector<std::string> concatenate(const Columns& other, std::size_t rows,
                                       std::size_t other_rows);
};

}  // namespace transformesh
