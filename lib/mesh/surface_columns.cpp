#include "mesh/surface_columns.h"

#include <algorithm>
#include <array>
#include <optional>

#include "transformesh/measure.h"

namespace transformesh {
namespace {

using NormalColumns = std::array<Column*, 3>;

// Returns the three columns of normals. Returns nothing if one of them is missing or is a list.
std::optional<NormalColumns> normal_columns(Columns& columns) {
  const NormalColumns found{columns.find("nx"), columns.find("ny"), columns.find("nz")};
  for (const Column* column : found)
    if (column == nullptr || column->list_count_type) return std::nullopt;
  return found;
}

void set_row(const NormalColumns& columns, std::size_t row, const Vec3& normal) {
  if (normal == Vec3::Zero()) return;
  for (std::size_t axis = 0; axis < 3; ++axis)
    columns[axis]->values[row] = normal[static_cast<Eigen::Index>(axis)];
}

// Appends the values of three corners of a polygon. `from` has a list of values for each row, with
// `width` values per corner.
void append_corners(Column& to, const Column& from, std::size_t row,
                    const std::array<std::uint32_t, 3>& corners, std::size_t width) {
  for (const std::uint32_t corner : corners)
    for (std::size_t i = 0; i < width; ++i)
      to.values.push_back(from.values[from.list_offsets[row] + corner * width + i]);
}

void append_list(Column& to, const Column& from, std::size_t row) {
  const auto begin = from.values.begin();
  to.values.insert(to.values.end(), begin + static_cast<std::ptrdiff_t>(from.list_offsets[row]),
                   begin + static_cast<std::ptrdiff_t>(from.list_offsets[row + 1]));
}

Column split_lists(const Column& column, std::span<const PolygonTriangle> triangles) {
  Column split{column.name, column.type, {}, column.list_count_type, {0}};
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const auto& [row, size, corners] = triangles[f];
    const std::size_t length = column.list_offsets[f + 1] - column.list_offsets[f];
    if (length % size == 0) {
      append_corners(split, column, f, corners, length / size);
    } else {
      append_list(split, column, f);
    }
    split.list_offsets.push_back(split.values.size());
  }
  return split;
}

}  // namespace

void make_floating(Column& column) {
  if (column.type != Scalar::float32 && column.type != Scalar::float64)
    column.type = Scalar::float64;
}

bool refresh_normals(Mesh& mesh) {
  for (Columns* columns : {&mesh.vertex_columns, &mesh.face_columns})
    if (const auto normals = normal_columns(*columns))
      for (Column* column : *normals) make_floating(*column);
  const auto of_vertices = normal_columns(mesh.vertex_columns);
  if (of_vertices) {
    const std::vector<Vec3> normals = vertex_normals(mesh);
    for (std::size_t v = 0; v < normals.size(); ++v) set_row(*of_vertices, v, normals[v]);
  }
  const auto of_faces = normal_columns(mesh.face_columns);
  if (of_faces) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      set_row(*of_faces, f, face_normal(mesh, static_cast<Index>(f)).stableNormalized());
  }
  return of_vertices || of_faces;
}

void reverse_normals(Mesh& mesh) {
  for (Columns* columns : {&mesh.vertex_columns, &mesh.face_columns}) {
    const auto normals = normal_columns(*columns);
    if (!normals) continue;
    for (Column* column : *normals) {
      const bool is_unsigned = column->type == Scalar::uint8 || column->type == Scalar::uint16 ||
                               column->type == Scalar::uint32;
      if (is_unsigned) make_floating(*column);
      for (double& value : column->values) value = 0 - value;
    }
  }
}

void reverse_corner_lists(Mesh& mesh, Index face) {
  for (Column& column : mesh.face_columns.columns) {
    if (!is_corner_list(column)) continue;
    const auto first = static_cast<std::ptrdiff_t>(column.list_offsets[face]);
    const auto last = static_cast<std::ptrdiff_t>(column.list_offsets[face + 1]);
    if ((last - first) % 3 != 0) continue;
    const std::ptrdiff_t width = (last - first) / 3;
    const auto second = column.values.begin() + first + width;
    std::swap_ranges(second, second + width, second + width);
  }
}

void reverse_faces(Mesh& mesh) {
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    std::swap(mesh.faces[f][1], mesh.faces[f][2]);
    reverse_corner_lists(mesh, f);
  }
  reverse_normals(mesh);
}

bool is_corner_list(const Column& column) {
  const bool is_floating = column.type == Scalar::float32 || column.type == Scalar::float64;
  return column.list_count_type && is_floating &&
         (column.name.find("tex") != std::string::npos ||
          column.name.find("uv") != std::string::npos);
}

std::vector<std::string> drop_corner_lists(Columns& face_columns) {
  std::vector<std::string> names;
  for (const Column& column : face_columns.columns)
    if (is_corner_list(column)) names.push_back(column.name);
  for (const std::string& name : names) face_columns.erase(name);
  return names;
}

bool has_source_columns(const Columns& columns) {
  return std::ranges::all_of(source_point_names, [&](const char* name) {
    const Column* column = columns.find(name);
    return column != nullptr && !column->list_count_type;
  });
}

bool drop_source_points(Mesh& mesh) {
  bool had_any = false;
  for (Columns* columns : {&mesh.vertex_columns, &mesh.face_columns}) {
    if (!has_source_columns(*columns)) continue;
    for (const char* name : source_point_names) columns->erase(name);
    had_any = true;
  }
  return had_any;
}

void split_corner_lists(Columns& face_columns, std::span<const PolygonTriangle> triangles) {
  for (Column& column : face_columns.columns)
    if (is_corner_list(column)) column = split_lists(column, triangles);
}

}  // namespace transformesh
