/// One PLY element while it is read into a mesh: where each property is stored, and the loop over
/// rows that both encodings share.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "io/formats/face_rows.h"
#include "io/formats/ply.h"
#include "io/formats/text_rows.h"

namespace transformesh {

struct PlyTable {
  struct Target {
    enum Kind { coordinate, face_list, column } kind = column;
    std::size_t index = 0;  ///< axis of a coordinate (0 to 2), or index of a column
  };

  PlyElement element;
  std::vector<Target> targets;     ///< for each property, where its values are stored
  std::uint64_t vertex_count = 0;  ///< number of vertices; vertex indices in faces must be smaller
  std::vector<Vec3> positions;     ///< positions of the vertices, if this is the vertex element
  FaceRows polygons;               ///< faces, if this is the face element
  Columns columns;
  std::size_t long_rows = 0;  ///< number of text lines with more values than properties
  const char* first_long_row = nullptr;

  /// Returns the size in bytes of a binary row whose face has this many corners and whose other
  /// lists are empty.
  std::size_t row_size(std::size_t corner_count) const;

  /// Returns the name of a row in messages: `vertex 12`, or `row 12 of element 'edge'`.
  std::string row_name(std::size_t row) const;
  std::string value_name(std::size_t row, const PlyProperty& property) const;
  [[nodiscard]] std::string bad_index(std::size_t row, double index) const;
};

/// Read the rows of a table from binary data or from text. Throw InputError. The data must be at
/// least as long as rows with empty lists. read_binary_rows() returns the end of the rows;
/// read_text_rows() advances `rows`.
const char* read_binary_rows(const Source& source, const char* place, bool swapped,
                             PlyTable& table);
void read_text_rows(TextRows& rows, PlyTable& table);

/// Reads one row and stores its values in the table. `cursor` provides the functions `double
/// scalar(property)`, `double coordinate(property)`, `std::uint64_t count(property)` and
/// `fail(message)`.
template <class Cursor>
void read_ply_row(Cursor& cursor, PlyTable& table, std::size_t row, std::vector<Index>& corners) {
  for (std::size_t i = 0; i < table.targets.size(); ++i) {
    const PlyProperty& property = table.element.properties[i];
    const PlyTable::Target target = table.targets[i];
    if (target.kind == PlyTable::Target::coordinate) {
      table.positions[row][static_cast<Eigen::Index>(target.index)] = cursor.coordinate(property);
    } else if (target.kind == PlyTable::Target::face_list) {
      corners.clear();
      for (std::uint64_t left = cursor.count(property); left > 0; --left) {
        const double index = cursor.scalar(property);
        if (!(index >= 0 && index < static_cast<double>(table.vertex_count))) {
          cursor.fail(table.bad_index(row, index));
        }
        corners.push_back(static_cast<Index>(index));
      }
      table.polygons.add(corners);
    } else {
      Column& column = table.columns.columns[target.index];
      std::uint64_t left = property.count_type ? cursor.count(property) : 1;
      for (; left > 0; --left) column.values.push_back(cursor.scalar(property));
      if (property.count_type) column.list_offsets.push_back(column.values.size());
    }
  }
}

}  // namespace transformesh
