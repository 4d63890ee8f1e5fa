#include <algorithm>
#include <map>

#include "io/document/losses.h"
#include "io/document/scalar.h"
#include "io/document/unit.h"
#include "io/formats/column_groups.h"
#include "io/formats/three_mf.h"
#include "io/formats/three_mf_model.h"
#include "io/streams/text_buffer.h"
#include "io/streams/zip_archive.h"
#include "mesh/color_scale.h"
#include "support/counted.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

constexpr std::string_view xml_start = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

constexpr std::string_view content_types =
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
    "<Default Extension=\"rels\" "
    "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
    "<Default Extension=\"model\" "
    "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
    "</Types>\n";

constexpr std::string_view relationships =
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";

/// Escapes a text for XML. Replaces control bytes other than line feeds by question marks, because
/// XML cannot represent them. Does the same with non-ASCII bytes, which may not be valid UTF-8.
std::string escaped_xml_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&' || c == '<' || c == '>') {
      result += "&#" + std::to_string(int{c}) + ';';
    } else {
      result += (c >= ' ' && c <= '~') || c == '\n' ? c : '?';
    }
  }
  return result;
}

class ThreeMfWriter {
 public:
  explicit ThreeMfWriter(const Document& document) : document_(document), mesh_(document.mesh) {}

  WriteResult write() {
    ZipWriter archive;
    archive.add("[Content_Types].xml", std::string(xml_start).append(content_types));
    archive.add("_rels/.rels", std::string(xml_start).append(relationships));
    find_colors();
    archive.add("3D/3dmodel.model", model());
    WriteResult result{archive.finish(),
                       losses(document_, {"3MF", kept_vertex_columns_, kept_face_columns_})};
    if (collapsed_ > 0)
      result.notes.push_back("3mf: " + counted(collapsed_, "face") +
                             " with two corners in one vertex cannot be stored in 3MF, dropped");
    if (are_rounded_) result.notes.emplace_back("3mf: colors are rounded to bytes");
    return result;
  }

 private:
  void find_colors() {
    colors_ = color_group(mesh_.vertex_columns);
    are_of_vertices_ = !colors_.empty() && are_in_range(colors_);
    if (!are_of_vertices_) colors_ = color_group(mesh_.face_columns);
    if (!are_in_range(colors_)) colors_.clear();
    std::vector<std::string_view>& kept =
        are_of_vertices_ ? kept_vertex_columns_ : kept_face_columns_;
    for (const Column* column : colors_) kept.push_back(column->name);
  }

  std::string model() {
    text_.add(xml_start);
    text_.add("<model unit=\"");
    const Unit* unit = unit_of(document_);
    text_.add(unit == nullptr ? "millimeter" : unit->name);
    text_.add(
        "\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
        "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">\n");
    add_description();
    text_.add("<resources>\n");
    add_color_group();
    text_.add("<object id=\"1\" type=\"model\"");
    if (!colors_.empty()) text_.add(" pid=\"2\" pindex=\"0\"");
    text_.add("><mesh>\n<vertices>\n");
    for (const Vec3& position : mesh_.positions) add_vertex(position);
    text_.add("</vertices>\n<triangles>\n");
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) add_triangle(f);
    text_.add(
        "</triangles>\n</mesh></object>\n</resources>\n<build><item objectid=\"1\"/></build>\n"
        "</model>\n");
    return text_.take();
  }

  void add_description() {
    std::string lines;
    for (const std::string& comment : document_.style.comments)
      if (!comment.starts_with("tm:unit ")) lines += escaped_xml_text(comment) + '\n';
    if (lines.empty()) return;
    lines.pop_back();
    text_.add("<metadata name=\"Description\">" + lines + "</metadata>\n");
  }

  /// Writes the group of distinct colors, numbered in the order of their first row.
  void add_color_group() {
    if (colors_.empty()) return;
    text_.add("<m:colorgroup id=\"2\">\n");
    std::map<ByteColor, std::size_t> numbers;
    for (std::size_t row = 0; row < colors_[0]->values.size(); ++row) {
      ByteColor color{0, 0, 0, 255};
      for (std::size_t c = 0; c < colors_.size(); ++c) color[c] = byte_of(*colors_[c], row);
      const auto [place, is_new] = numbers.emplace(color, numbers.size());
      color_numbers_.push_back(place->second);
      if (is_new) add_color(color);
    }
    text_.add("</m:colorgroup>\n");
  }

  std::uint8_t byte_of(const Column& channel, std::size_t row) {
    const double value = channel.values[row] * 255 / full_intensity(channel.type);
    const auto byte = to_scalar<std::uint8_t>(value);
    are_rounded_ = are_rounded_ || byte != value;
    return byte;
  }

  void add_color(const ByteColor& color) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    text_.add("<m:color color=\"#");
    for (std::size_t c = 0; c < colors_.size(); ++c) {
      text_.add(digits[color[c] / 16U]);
      text_.add(digits[color[c] % 16U]);
    }
    text_.add("\"/>\n");
  }

  template <class T>
  void add_attribute(std::string_view name, T value) {
    text_.add(' ');
    text_.add(name);
    text_.add("=\"");
    text_.add_number(value);
    text_.add('"');
  }

  void add_vertex(const Vec3& position) {
    const bool is_single = document_.style.coordinate == Scalar::float32;
    constexpr std::array<const char*, 3> names{"x", "y", "z"};
    text_.add("<vertex");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double value = position[static_cast<Eigen::Index>(axis)];
      is_single ? add_attribute(names[axis], static_cast<float>(value))
                : add_attribute(names[axis], value);
    }
    text_.add("/>\n");
  }

  void add_triangle(std::size_t f) {
    const Face& face = mesh_.faces[f];
    if (is_collapsed(face)) {
      ++collapsed_;
      return;
    }
    constexpr std::array<const char*, 3> corners{"v1", "v2", "v3"};
    constexpr std::array<const char*, 3> properties{"p1", "p2", "p3"};
    text_.add("<triangle");
    for (std::size_t i = 0; i < 3; ++i) add_attribute(corners[i], face[i]);
    if (!colors_.empty()) add_attribute("pid", 2);
    for (std::size_t i = 0; i < (colors_.empty() ? 0U : 3U); ++i)
      add_attribute(properties[i], color_numbers_[are_of_vertices_ ? face[i] : f]);
    text_.add("/>\n");
  }

  const Document& document_;
  const Mesh& mesh_;
  TextBuffer text_;
  ColumnGroup colors_;
  bool are_rounded_ = false;
  bool are_of_vertices_ = false;
  /// For each row, the index of its color in the color group.
  std::vector<std::size_t> color_numbers_;
  std::vector<std::string_view> kept_vertex_columns_, kept_face_columns_;
  std::size_t collapsed_ = 0;
};

}  // namespace

WriteResult write_three_mf(const Document& document) {
  if (document.mesh.faces.empty())
    throw GoalError("3MF holds no points, and this mesh has no faces: write XYZ or PLY");
  return ThreeMfWriter(document).write();
}

}  // namespace transformesh
