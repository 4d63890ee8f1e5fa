#include <bit>
#include <map>
#include <unordered_map>

#include "io/document/losses.h"
#include "io/document/scalar.h"
#include "io/formats/column_groups.h"
#include "io/formats/obj.h"
#include "io/formats/obj_labels.h"
#include "io/formats/vtk.h"
#include "io/polygons/merge_polygons.h"
#include "io/streams/text_buffer.h"
#include "mesh/color_scale.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

std::vector<const Column*> color_columns(const Columns& columns) {
  if (!has_columns(columns, {"red", "green", "blue"})) return {};
  return {columns.find("red"), columns.find("green"), columns.find("blue")};
}

/// A face column of labels, with the names of the labels. In OBJ, a label statement applies to all
/// following faces until the next statement.
struct Labels {
  const ObjLabelKind* kind = nullptr;
  const Column* column = nullptr;
  std::map<long, std::string> names;
  std::string current;

  std::string name_of(long number) const {
    const auto found = names.find(number);
    if (found != names.end()) return found->second;
    return number == 0 ? std::string(kind->none) : std::to_string(number);
  }
};

class ObjWriter {
 public:
  ObjWriter(const Document& document, const Column* outlines)
      : document_(document), mesh_(document.mesh), lists_(outlines), outlines_(mesh_, outlines) {}

  WriteResult write() {
    add_comment_lines();
    // Write a statement for a mesh without vertices, so that readers can detect the format.
    if (mesh_.positions.empty()) text_.add("o empty\n");
    add_vertices();
    find_texture();
    find_labels();
    add_faces();
    return {unlike_vtk(text_.take()), losses(document_, keeps_)};
  }

 private:
  void add_comment_lines() {
    std::vector<std::string> all, comments;
    for (const std::string& comment : document_.style.comments) all.push_back(as_comment(comment));
    std::remove_copy_if(all.begin(), all.end(), std::back_inserter(comments), is_obj_comment);
    add_comments("#", comments, text_);
    for (const std::string& comment : all)
      if (comment.starts_with(obj_library_comment))
        add_statement("mtllib",
                      as_obj_name(std::string_view(comment).substr(obj_library_comment.size())));
  }

  void add_statement(std::string_view keyword, std::string_view name) {
    if (name.empty()) return;
    text_.add(keyword);
    text_.add(' ');
    text_.add(name);
    text_.add('\n');
  }

  void add_vertices() {
    const std::vector<const Column*> colors = color_columns(mesh_.vertex_columns);
    keep(colors, keeps_.vertex_columns);
    for (std::size_t row = 0; row < mesh_.positions.size(); ++row) {
      text_.add('v');
      for (const Eigen::Index axis : {0, 1, 2}) {
        text_.add(' ');
        text_.add_number(mesh_.positions[row][axis]);
      }
      for (const Column* column : colors) {
        text_.add(' ');
        text_.add_number(column->values[row] / full_intensity(column->type));
      }
      text_.add('\n');
    }
  }

  static void keep(const ColumnGroup& columns, std::vector<std::string_view>& names) {
    for (const Column* column : columns) names.push_back(column->name);
  }

  void find_texture() {
    if (mesh_.faces.empty()) return;
    if (const Column* lists = corner_texture(mesh_.face_columns, lists_)) {
      keep({lists}, keeps_.face_columns);
      add_corner_texture(*lists);
      return;
    }
    const ColumnGroup group = texture_group(mesh_.vertex_columns);
    if (group.empty() || !is_floating(group[0]->type)) return;
    keep(group, keeps_.vertex_columns);
    for (std::size_t row = 0; row < mesh_.positions.size(); ++row)
      add_texture_point(group[0]->values[row], group[1]->values[row], group[0]->type);
    for (std::size_t row = 0; row < mesh_.faces.size(); ++row)
      for (std::size_t i = 0; i < outlines_.size(row); ++i)
        texture_corners_.push_back(std::uint64_t{outlines_.corner(row, i)} + 1);
  }

  void add_texture_point(double u, double v, Scalar type) {
    text_.add("vt");
    for (const double value : {u, v}) {
      text_.add(' ');
      type == Scalar::float32 ? text_.add_number(static_cast<float>(value))
                              : text_.add_number(value);
    }
    text_.add('\n');
  }

  /// Writes the texture coordinates of corners. Texture coordinates with identical bits are written
  /// once.
  void add_corner_texture(const Column& lists) {
    using Bits = std::pair<std::uint64_t, std::uint64_t>;
    const auto hash = [](const Bits& bits) {
      // Multiplier of a hash that spreads its bits: 2^64 divided by the golden ratio.
      constexpr std::uint64_t odd = 0x9e3779b97f4a7c15U;
      return (bits.first * odd ^ bits.second) * odd >> 16U;
    };
    std::unordered_map<Bits, std::uint64_t, decltype(hash)> numbers(0, hash);
    for (std::size_t row = 0; row + 1 < lists.list_offsets.size(); ++row) {
      const std::size_t first = lists.list_offsets[row];
      for (std::size_t i = 0; i < outlines_.size(row); ++i) {
        if (first == lists.list_offsets[row + 1]) {
          texture_corners_.push_back(0);
          continue;
        }
        const double u = lists.values[first + 2 * i];
        const double v = lists.values[first + 2 * i + 1];
        const Bits bits(std::bit_cast<std::uint64_t>(u), std::bit_cast<std::uint64_t>(v));
        const auto [place, is_new] = numbers.emplace(bits, numbers.size() + 1);
        if (is_new) add_texture_point(u, v, lists.type);
        texture_corners_.push_back(place->second);
      }
    }
  }

  void find_labels() {
    for (const ObjLabelKind& kind : obj_label_kinds) {
      if (!has_columns(mesh_.face_columns, {kind.column})) continue;
      const Column* column = mesh_.face_columns.find(kind.column);
      if (is_floating(column->type)) continue;
      keep({column}, keeps_.face_columns);
      labels_.push_back({&kind, column, obj_label_names(kind, document_.style.comments), {}});
      labels_.back().current = labels_.back().name_of(0);
    }
  }

  void add_labels(std::size_t row) {
    for (Labels& labels : labels_) {
      std::string name = labels.name_of(static_cast<long>(labels.column->values[row]));
      if (name == labels.current) continue;
      add_statement(labels.kind->keyword, name);
      labels.current = std::move(name);
    }
  }

  void add_faces() {
    std::size_t corner = 0;
    for (std::size_t row = 0; row < mesh_.faces.size(); ++row) {
      add_labels(row);
      text_.add('f');
      for (std::size_t i = 0; i < outlines_.size(row); ++i, ++corner) {
        text_.add(' ');
        text_.add_number(std::uint64_t{outlines_.corner(row, i)} + 1);
        const std::uint64_t texture = texture_corners_.empty() ? 0 : texture_corners_[corner];
        if (texture == 0) continue;
        text_.add('/');
        text_.add_number(texture);
      }
      text_.add('\n');
    }
  }

  const Document& document_;
  const Mesh& mesh_;
  TextBuffer text_;
  /// MergedPolygons::outlines, the corners of polygons; null if faces are triangles.
  const Column* lists_;
  FaceOutlines outlines_;
  Keeps keeps_{"OBJ", {}, {}};
  /// For each corner, the number of its texture coordinate, or 0 if it has none. Empty if no corner
  /// has one.
  std::vector<std::uint64_t> texture_corners_;
  std::vector<Labels> labels_;
};

}  // namespace

WriteResult write_obj(const Document& document, const Column* outlines) {
  return ObjWriter(document, outlines).write();
}

}  // namespace transformesh
