#include "io/formats/obj_texture.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "support/counted.h"

namespace transformesh {
namespace {

/// True if the value, after a conversion to float, is written as the same text. Then the conversion
/// to float loses nothing.
bool is_text_of_float(double value) {
  std::array<char, 32> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), static_cast<float>(value));
  double back = 0;
  return error == std::errc() && std::from_chars(text.data(), end, back).ec == std::errc() &&
         back == value;
}

}  // namespace

void ObjTexture::add_face(std::uint32_t row, std::span<const Index> corners,
                          std::span<const std::int64_t> numbers) {
  const bool has_any = std::any_of(numbers.begin(), numbers.end(), [](auto n) { return n != 0; });
  if (!is_used()) {
    if (!has_any) return;
    offsets_.assign(std::size_t{row} + 1, 0);
  }
  if (has_any) {
    const auto known = static_cast<std::int64_t>(points_.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const std::int64_t point = numbers[i] < 0 ? known + numbers[i] : numbers[i] - 1;
      corners_.push_back(point < 0 || point >= no_index ? no_index : static_cast<Index>(point));
      has_numbers_of_vertices_ = has_numbers_of_vertices_ && corners_.back() == corners[i];
    }
  }
  offsets_.push_back(corners_.size());
}

void ObjTexture::move_into(Mesh& mesh, std::uint32_t rows, std::vector<std::string>& notes) {
  if (!is_used()) return;
  if (are_of_vertices(mesh.positions.size(), rows)) return add_vertex_columns(mesh);
  const std::size_t incomplete = add_lists(mesh, rows);
  if (incomplete == 0) return;
  notes.push_back("obj: " + counted(incomplete, "face") +
                  " left without texture coordinates, because those of a corner are missing");
}

bool ObjTexture::is_there(Index point) const {
  return point < points_.size() && std::isfinite(points_[point][0]) &&
         std::isfinite(points_[point][1]);
}

bool ObjTexture::are_of_vertices(std::size_t vertices, std::uint32_t rows) const {
  if (!has_numbers_of_vertices_ || points_.size() != vertices) return false;
  for (std::uint32_t row = 0; row < rows; ++row)
    if (offsets_[row] == offsets_[row + 1]) return false;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (!is_there(static_cast<Index>(i))) return false;
  return true;
}

Scalar ObjTexture::type() const {
  const bool are_floats = std::all_of(points_.begin(), points_.end(), [](const auto& point) {
    return is_text_of_float(point[0]) && is_text_of_float(point[1]);
  });
  return are_floats ? Scalar::float32 : Scalar::float64;
}

void ObjTexture::add_vertex_columns(Mesh& mesh) const {
  const Scalar wanted = type();
  for (const std::size_t axis : {0, 1}) {
    Column& column = mesh.vertex_columns.get(axis == 0 ? "s" : "t", wanted, points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i)
      column.values[i] = wanted == Scalar::float32
                             ? static_cast<double>(static_cast<float>(points_[i][axis]))
                             : points_[i][axis];
  }
}

std::size_t ObjTexture::add_lists(Mesh& mesh, std::uint32_t rows) const {
  std::size_t incomplete = 0;
  Column column{"texcoord", type(), {}, Scalar::uint8, {0}};
  for (std::uint32_t row = 0; row < rows; ++row) {
    const std::span<const Index> corners(corners_.data() + offsets_[row],
                                         offsets_[row + 1] - offsets_[row]);
    if (std::all_of(corners.begin(), corners.end(), [&](Index i) { return is_there(i); })) {
      for (const Index corner : corners)
        column.values.insert(column.values.end(), points_[corner].begin(), points_[corner].end());
    } else {
      ++incomplete;
    }
    column.list_offsets.push_back(column.values.size());
  }
  if (column.type == Scalar::float32)
    for (double& value : column.values) value = static_cast<double>(static_cast<float>(value));
  if (!column.values.empty()) mesh.face_columns.columns.push_back(std::move(column));
  return incomplete;
}

}  // namespace transformesh
