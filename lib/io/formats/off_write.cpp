#include <algorithm>

#include "io/document/losses.h"
#include "io/document/scalar.h"
#include "io/formats/off.h"
#include "io/polygons/merge_polygons.h"
#include "io/streams/text_buffer.h"
#include "mesh/color_scale.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

/// Returns the names of the color columns that OFF can store, in the order of OFF.
std::vector<std::string_view> color_names(const Columns& columns) {
  if (!has_columns(columns, {"red", "green", "blue"})) return {};
  if (!has_columns(columns, {"alpha"})) return {"red", "green", "blue"};
  return {"red", "green", "blue", "alpha"};
}

class OffWriter {
 public:
  OffWriter(const Document& document, const Column* outlines)
      : document_(document), mesh_(document.mesh), outlines_(mesh_, outlines) {
    if (has_columns(mesh_.vertex_columns, {"nx", "ny", "nz"})) normals_ = {"nx", "ny", "nz"};
    if (has_columns(mesh_.vertex_columns, {"s", "t"})) texture_ = {"s", "t"};
    colors_ = color_names(mesh_.vertex_columns);
    face_colors_ = color_names(mesh_.face_columns);
    if (face_colors_.empty() && has_columns(mesh_.face_columns, {"color_index"})) {
      face_colors_ = {"color_index"};
    }
  }

  WriteResult write() {
    add_header();
    add_vertices();
    add_faces();
    Keeps keeps{"OFF", normals_, face_colors_};
    keeps.vertex_columns.insert(keeps.vertex_columns.end(), colors_.begin(), colors_.end());
    keeps.vertex_columns.insert(keeps.vertex_columns.end(), texture_.begin(), texture_.end());
    return {text_.take(), losses(document_, keeps)};
  }

 private:
  void add_header() {
    if (!texture_.empty()) text_.add("ST");
    if (!colors_.empty()) text_.add("C");
    if (!normals_.empty()) text_.add("N");
    text_.add("OFF\n");
    add_comments("#", document_.style.comments, text_);
    text_.add_number(mesh_.positions.size());
    text_.add(' ');
    text_.add_number(mesh_.faces.size());
    text_.add(" 0\n");
  }

  void add_vertices() {
    for (std::size_t row = 0; row < mesh_.positions.size(); ++row) {
      const Vec3& position = mesh_.positions[row];
      text_.add_number(position[0]);
      for (const Eigen::Index axis : {1, 2}) {
        text_.add(' ');
        text_.add_number(position[axis]);
      }
      add_numbers(normals_, row);
      add_colors(mesh_.vertex_columns, colors_, row);
      add_numbers(texture_, row);
      text_.add('\n');
    }
  }

  void add_faces() {
    for (std::size_t row = 0; row < mesh_.faces.size(); ++row) {
      text_.add_number(outlines_.size(row));
      for (std::size_t i = 0; i < outlines_.size(row); ++i) {
        text_.add(' ');
        text_.add_number(outlines_.corner(row, i));
      }
      add_colors(mesh_.face_columns, face_colors_, row);
      text_.add('\n');
    }
  }

  /// Writes the color of a row. In OFF only a decimal point or an exponent distinguishes
  /// floating-point from integer colors, so all channels are written in the same way. Colors of
  /// ushort become decimals, because integers of OFF are from 0 to 255.
  void add_colors(const Columns& columns, const std::vector<std::string_view>& names,
                  std::size_t row) {
    const bool are_decimal = std::any_of(names.begin(), names.end(), [&](std::string_view name) {
      const Scalar type = columns.find(name)->type;
      return is_floating(type) || (type == Scalar::uint16 && name != "color_index");
    });
    for (const std::string_view name : names) {
      const Column& column = *columns.find(name);
      text_.add(' ');
      if (are_decimal) {
        text_.add_decimal(column.values[row] / full_intensity(column.type));
      } else {
        text_.add_number(to_scalar<std::int64_t>(column.values[row]));
      }
    }
  }

  void add_numbers(const std::vector<std::string_view>& names, std::size_t row) {
    for (const std::string_view name : names) {
      text_.add(' ');
      text_.add_number(mesh_.vertex_columns.find(name)->values[row]);
    }
  }

  const Document& document_;
  const Mesh& mesh_;
  FaceOutlines outlines_;
  std::vector<std::string_view> normals_;
  std::vector<std::string_view> colors_;
  std::vector<std::string_view> texture_;
  std::vector<std::string_view> face_colors_;
  TextBuffer text_;
};

}  // namespace

WriteResult write_off(const Document& document, const Column* outlines) {
  return OffWriter(document, outlines).write();
}

}  // namespace transformesh
