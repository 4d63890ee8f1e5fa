#include <algorithm>
#include <atomic>

#include "io/document/finite_positions.h"
#include "io/document/scalar.h"
#include "io/document/scalar_bytes.h"
#include "io/formats/ply_table.h"
#include "support/atomic_minimum.h"
#include "support/counted.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

/// Reads the values of rows from binary data.
class BinaryCursor {
 public:
  BinaryCursor(const Source& source, const char* place, bool swapped, const PlyTable& table)
      : source_(source), place_(place), swapped_(swapped), table_(table) {}

  void start_row(std::size_t row) { row_ = row; }
  const char* place() const { return place_; }

  double scalar(const PlyProperty& property) { return load(property.type, property); }

  double coordinate(const PlyProperty& property) {
    const double value = scalar(property);
    if (source_.is_strict && !std::isfinite(value))
      fail(table_.value_name(row_, property) + " is not a finite number");
    return value;
  }

  std::uint64_t count(const PlyProperty& property) {
    const double value = load(*property.count_type, property);
    const std::size_t size = byte_size(property.type);
    const std::size_t most = bytes_left() / size;
    if (value < 0 || value > static_cast<double>(most)) {
      fail("the length of " + table_.value_name(row_, property) + " is " +
           std::to_string(static_cast<long>(value)) + ", with only " +
           counted(bytes_left(), "byte") + " left");
    }
    return static_cast<std::uint64_t>(value);
  }

  [[noreturn]] void fail(const std::string& what) const { source_.fail_at_byte(place_, what); }

 private:
  std::size_t bytes_left() const { return static_cast<std::size_t>(source_.end() - place_); }

  double load(Scalar type, const PlyProperty& property) {
    return with_scalar(type, [&](auto zero) {
      using T = decltype(zero);
      if (bytes_left() < sizeof(T)) {
        fail("the data ends within " + table_.value_name(row_, property));
      }
      const T value = load_scalar<T>(place_, swapped_);
      place_ += sizeof(T);
      return static_cast<double>(value);
    });
  }

  const Source& source_;
  const char* place_;
  bool swapped_;
  const PlyTable& table_;
  std::size_t row_ = 0;
};

/// Reads rows of equal size fast, with one loop for each property.
class FixedRows {
 public:
  FixedRows(const char* first, std::size_t stride, std::size_t count, bool swapped)
      : first_(first), stride_(stride), count_(count), swapped_(swapped) {}

  /// Decodes the values of a property, which are at `offset` in each row. Writes them to `to`,
  /// `step` doubles apart.
  void decode(Scalar type, std::size_t offset, double* to, std::size_t step) const {
    with_scalar(type, [&](auto zero) {
      parallel_for(count_, rows_per_task, [&](std::size_t first, std::size_t last) {
        const char* from = first_ + offset + first * stride_;
        for (std::size_t row = first; row < last; ++row, from += stride_)
          to[row * step] = static_cast<double>(load_scalar<decltype(zero)>(from, swapped_));
      });
    });
  }

  /// Adds the triangles of rows, up to the first row that is not a triangle or has an index out of
  /// range. The list of corner indices is at `offset` in each row. Returns the number of triangles.
  template <class T>
  std::size_t decode_triangles(std::size_t offset, std::uint64_t vertex_count,
                               FaceRows& polygons) const {
    const auto limit = static_cast<Index>(
        std::min<std::uint64_t>(vertex_count, std::uint64_t{std::numeric_limits<T>::max()} + 1));
    std::vector<Face> triangles(count_);
    std::atomic<std::size_t> first_other = count_;
    parallel_for(count_, rows_per_task, [&](std::size_t first, std::size_t last) {
      const char* from = first_ + offset + first * stride_;
      for (std::size_t row = first; row < last; ++row, from += stride_) {
        const Face face{corner<T>(from, 0), corner<T>(from, 1), corner<T>(from, 2)};
        const bool in_range = face[0] < limit && face[1] < limit && face[2] < limit;
        if (*from != 3 || !in_range) return lower_to(first_other, row);
        triangles[row] = face;
      }
    });
    triangles.resize(first_other);
    polygons.add(std::move(triangles));
    return first_other;
  }

 private:
  static constexpr std::size_t rows_per_task = 8192;  ///< affects time only

  template <class T>
  Index corner(const char* list, std::size_t i) const {
    return static_cast<Index>(load_scalar<T>(list + 1 + i * sizeof(T), swapped_));
  }

  const char* first_;
  std::size_t stride_;
  std::size_t count_;
  bool swapped_;
};

void decode_columns(const FixedRows& rows, std::size_t count, PlyTable& table) {
  std::size_t offset = 0;
  for (std::size_t i = 0; i < table.targets.size(); ++i) {
    const PlyProperty& property = table.element.properties[i];
    const PlyTable::Target target = table.targets[i];
    if (target.kind == PlyTable::Target::face_list) {
      offset += 1 + 3 * byte_size(property.type);
      continue;
    }
    if (target.kind == PlyTable::Target::coordinate && count > 0) {
      rows.decode(property.type, offset, table.positions[0].data() + target.index, 3);
    } else if (target.kind == PlyTable::Target::column) {
      std::vector<double>& values = table.columns.columns[target.index].values;
      values.resize(count);
      rows.decode(property.type, offset, values.data(), 1);
    }
    offset += byte_size(property.type);
  }
}

void check_positions(const Source& source, const char* place, const PlyTable& table) {
  if (are_finite(table.positions)) return;
  const std::size_t stride = table.row_size(0);
  for (std::size_t row = 0; row < table.positions.size(); ++row) {
    if (table.positions[row].allFinite()) continue;
    source.fail_at_byte(place + row * stride,
                        table.row_name(row) + " has a coordinate that is not a finite number");
  }
}

const PlyProperty* only_face_list(const PlyTable& table, std::size_t& offset) {
  const PlyProperty* list = nullptr;
  std::size_t before = 0;
  for (std::size_t i = 0; i < table.targets.size(); ++i) {
    const PlyProperty& property = table.element.properties[i];
    if (table.targets[i].kind == PlyTable::Target::face_list) {
      list = &property;
      offset = before;
    } else if (property.count_type) {
      return nullptr;
    }
    before += byte_size(property.type);
  }
  const bool is_common = list && byte_size(*list->count_type) == 1 && byte_size(list->type) == 4;
  return is_common ? list : nullptr;
}

/// Reads the triangles at the start of a face element, if its only list holds the corners, with a
/// count of one byte and indices of four bytes. Returns the number of triangles that were read.
std::size_t read_triangles(const Source& source, const char* place, bool swapped, PlyTable& table) {
  std::size_t offset = 0;
  const PlyProperty* list = only_face_list(table, offset);
  if (!list) return 0;
  const std::size_t stride = table.row_size(3);
  const auto left = static_cast<std::size_t>(source.end() - place);
  const auto most =
      static_cast<std::size_t>(std::min<std::uint64_t>(table.element.rows, left / stride));
  const FixedRows rows(place, stride, most, swapped);
  const std::size_t count =
      list->type == Scalar::int32
          ? rows.decode_triangles<std::int32_t>(offset, table.vertex_count, table.polygons)
          : rows.decode_triangles<std::uint32_t>(offset, table.vertex_count, table.polygons);
  decode_columns(FixedRows(place, stride, count, swapped), count, table);
  return count;
}

bool has_list(const PlyTable& table) {
  return std::any_of(table.element.properties.begin(), table.element.properties.end(),
                     [](const PlyProperty& property) { return property.count_type.has_value(); });
}

}  // namespace

const char* read_binary_rows(const Source& source, const char* place, bool swapped,
                             PlyTable& table) {
  if (table.element.properties.empty()) return place;
  const auto row_count = static_cast<std::size_t>(table.element.rows);
  if (table.element.name == "vertex") table.positions.resize(row_count);
  if (!has_list(table)) {
    const std::size_t stride = table.row_size(0);
    decode_columns(FixedRows(place, stride, row_count, swapped), row_count, table);
    if (source.is_strict) check_positions(source, place, table);
    return place + row_count * stride;
  }
  const std::size_t triangles = read_triangles(source, place, swapped, table);
  BinaryCursor cursor(source, place + triangles * table.row_size(3), swapped, table);
  std::vector<Index> corners;
  for (std::size_t row = triangles; row < row_count; ++row) {
    cursor.start_row(row);
    read_ply_row(cursor, table, row, corners);
  }
  return cursor.place();
}

}  // namespace transformesh
