#include "io/formats/vtk_data.h"

#include <algorithm>
#include <cmath>

#include "io/document/scalar.h"
#include "io/formats/column_groups.h"
#include "io/formats/face_rows.h"
#include "io/formats/finite_values.h"
#include "mesh/coordinate_spacing.h"
#include "mesh/index_limits.h"
#include "support/counted.h"

namespace transformesh {
namespace {

class Converter {
 public:
  Converter(const Source& source, VtkPiece piece) : source_(source), piece_(std::move(piece)) {}

  ReadResult read() {
    result_.document.style.format = Format::vtp;
    result_.document.style.coordinate =
        piece_.points.type == Scalar::float32 ? Scalar::float32 : Scalar::float64;
    add_points();
    Mesh& mesh = result_.document.mesh;
    add_columns(piece_.point_arrays, mesh.positions.size(), "point", mesh.vertex_columns);
    add_faces();
    zero_values_not_finite(mesh.vertex_columns, source_, "vertex", "vtk", result_.notes);
    faces_.keep_polygons(source_.keeps_polygons);
    faces_.move_into(mesh, "vtk", result_.notes);
    if (piece_.other_cells > 0)
      note(counted(piece_.other_cells, "cell") + " other than polygons left out");
    return std::move(result_);
  }

 private:
  void note(const std::string& text) { result_.notes.push_back("vtk: " + text); }

  void add_points() {
    const std::vector<double>& values = piece_.points.values;
    if (values.size() / 3 >= no_index) source_.fail(too_many_vertices);
    for (std::size_t i = 2; i < values.size(); i += 3)
      result_.document.mesh.positions.emplace_back(values[i - 2], values[i - 1], values[i]);
  }

  // --- Arrays ------------------------------------------------------------------------------------

  void add_columns(const std::vector<VtkArray>& arrays, std::size_t rows, const char* element,
                   Columns& columns) {
    for (const VtkArray& array : arrays) {
      if (array.values.size() != rows * array.components)
        source_.fail("the array " + in_quotes(array.name) + " has " +
                     counted(array.values.size(), "number") + ", but " + there_are(rows, element) +
                     " of " + counted(array.components, "component"));
      if (array.has_long_integers)
        note_rounded_integers(array.values, "array " + in_quotes(array.name), "vtk", result_.notes);
      add_array(array, rows, columns);
    }
  }

  void add_array(const VtkArray& array, std::size_t rows, Columns& columns) {
    const auto is = [&](const char* role, std::size_t components) {
      return array.components == components && (array.role == role || array.name == role);
    };
    const std::size_t width = array.components;
    const bool is_color = (array.type == Scalar::uint8 && (width == 3 || width == 4)) ||
                          (array.name == "RGB" && width == 3) ||
                          (array.name == "RGBA" && width == 4);
    if (is("Normals", 3)) {
      add_group({"nx", "ny", "nz"}, array, rows, columns);
    } else if (is("TCoords", 2)) {
      add_group({"s", "t"}, array, rows, columns);
    } else if (is_color && columns.find("red") == nullptr) {
      std::vector<std::string> names(color_channels.begin(), color_channels.end());
      names.resize(width);
      add_group(names, array, rows, columns);
    } else if (width == 1) {
      add_group({column_name(array.name)}, array, rows, columns);
    } else {
      add_list(array, rows, columns);
    }
  }

  static void add_group(const std::vector<std::string>& names, const VtkArray& array,
                        std::size_t rows, Columns& columns) {
    for (std::size_t c = 0; c < names.size(); ++c) {
      Column& column = columns.get(names[c], array.type, rows);
      for (std::size_t row = 0; row < rows; ++row)
        column.values[row] = array.values[row * names.size() + c];
    }
  }

  void add_list(const VtkArray& array, std::size_t rows, Columns& columns) {
    // Largest number of values in a list whose count has 8 bits.
    constexpr std::size_t most = 255;
    if (array.components > most) {
      note("array " + in_quotes(array.name) + " of " + counted(array.components, "component") +
           " left out");
      return;
    }
    Column& column = columns.get(column_name(array.name), array.type, 0);
    column.list_count_type = Scalar::uint8;
    column.values = array.values;
    for (std::size_t row = 0; row <= rows; ++row)
      column.list_offsets.push_back(row * array.components);
  }

  // --- Faces -------------------------------------------------------------------------------------

  void add_faces() {
    Columns columns;
    add_columns(piece_.cell_arrays, piece_.cells, "cell", columns);
    std::vector<Index> corners;
    for (std::size_t i = 0; i < piece_.polygons.size(); ++i) {
      read_corners(piece_.polygons, i, corners);
      faces_.add(corners);
      rows_.push_back(static_cast<std::uint32_t>(piece_.polygons.rows[i]));
    }
    for (std::size_t i = 0; i < piece_.strips.size(); ++i) {
      read_corners(piece_.strips, i, corners);
      add_strip(corners, static_cast<std::uint32_t>(piece_.strips.rows[i]));
    }
    result_.document.mesh.face_columns = columns.select(rows_);
  }

  void read_corners(const VtkCells& cells, std::size_t i, std::vector<Index>& corners) const {
    const std::size_t points = result_.document.mesh.positions.size();
    const std::uint64_t first = cells.offsets[i], last = cells.offsets[i + 1];
    if (first > last || last > cells.connectivity.size())
      source_.fail("the offsets of cell " + std::to_string(cells.rows[i]) + " are out of range");
    corners.clear();
    for (std::uint64_t k = first; k < last; ++k) {
      if (cells.connectivity[k] >= points)
        source_.fail("cell " + std::to_string(cells.rows[i]) + " has point index " +
                     std::to_string(cells.connectivity[k]) + ", but " + there_are(points, "point"));
      corners.push_back(static_cast<Index>(cells.connectivity[k]));
    }
  }

  /// Adds the triangles of a triangle strip. Every second triangle is reversed.
  void add_strip(const std::vector<Index>& corners, std::uint32_t row) {
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const std::size_t turned = i % 2;
      faces_.add(Face{corners[i - 2], corners[i - 1 + turned], corners[i - turned]});
      rows_.push_back(row);
    }
  }

  const Source& source_;
  VtkPiece piece_;
  FaceRows faces_;
  /// For each face, the row of its cell in the arrays of cell data.
  std::vector<std::uint32_t> rows_;
  ReadResult result_;
};

bool are_held(Scalar type, const std::vector<double>& values) {
  return with_scalar(type, [&](auto zero) {
    using T = decltype(zero);
    return std::all_of(values.begin(), values.end(), [](double value) {
      return static_cast<double>(to_scalar<T>(value)) == value;
    });
  });
}

}  // namespace

ReadResult mesh_of_vtk(const Source& source, VtkPiece piece) {
  return Converter(source, std::move(piece)).read();
}

void set_type(bool is_floating, bool is_signed, std::size_t bytes, VtkArray& array) {
  if (is_floating) {
    array.type = bytes == 4 ? Scalar::float32 : Scalar::float64;
    if (bytes == 4)
      for (double& value : array.values) value = round_to_single(value);
    return;
  }
  array.has_long_integers = bytes == 8;
  Scalar type = Scalar::int32;
  if (bytes == 1) type = is_signed ? Scalar::int8 : Scalar::uint8;
  if (bytes == 2) type = is_signed ? Scalar::int16 : Scalar::uint16;
  if (bytes == 4) type = is_signed ? Scalar::int32 : Scalar::uint32;
  array.type = Scalar::float64;
  for (const Scalar candidate : {Scalar::int32, type})
    if (are_held(candidate, array.values)) array.type = candidate;
}

}  // namespace transformesh
