#include <algorithm>
#include <array>
#include <map>

#include "io/formats/color_rows.h"
#include "io/formats/face_rows.h"
#include "io/formats/finite_values.h"
#include "io/formats/obj.h"
#include "io/formats/obj_labels.h"
#include "io/formats/obj_texture.h"
#include "io/formats/text_rows.h"
#include "mesh/index_limits.h"
#include "support/counted.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

/// True if the word starts a statement of OBJ other than a vertex or a face.
bool is_other_keyword(std::string_view word) {
  constexpr std::array<std::string_view, 37> words{
      "bevel", "bmat",     "bsp",    "bzp",        "c_interp", "call",  "cdc",  "cdp",
      "con",   "csh",      "cstype", "ctech",      "curv",     "curv2", "deg",  "end",
      "hole",  "l",        "lod",    "maplib",     "mg",       "p",     "parm", "res",
      "s",     "scrv",     "sp",     "stech",      "step",     "surf",  "trim", "vn",
      "vp",    "d_interp", "usemap", "shadow_obj", "trace_obj"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjReader {
 public:
  explicit ObjReader(const Source& source) : source_(source), rows_(source, 0, {'#', true}) {}

  ReadResult read() {
    while (rows_.next_row()) read_row(rows_.word());
    if (unknown_lines_ > 0 && mesh().positions.empty())
      source_.fail_at_line(first_unknown_.data(), unknown_statement());
    if (largest_index_ >= mesh().positions.size() && largest_index_place_) {
      source_.fail_at_line(largest_index_place_, out_of_range(largest_index_ + 1));
    }
    add_colors();
    add_comments();
    add_face_columns();
    polygons_.keep_polygons(source_.keeps_polygons);
    polygons_.move_into(mesh(), "obj", result_.notes, 1);
    add_notes();
    result_.document.style.format = Format::obj;
    return std::move(result_);
  }

 private:
  Mesh& mesh() { return result_.document.mesh; }

  void read_row(std::string_view keyword) {
    if (keyword == "v") {
      read_vertex();
    } else if (keyword == "f" || keyword == "fo") {
      read_face();
    } else if (keyword == "vt") {
      read_texture_point();
    } else if (keyword == "mtllib") {
      libraries_.push_back(as_obj_name(rows_.skip_row()));
    } else if (is_other_keyword(keyword)) {
      ++ignored_[keyword];
    } else if (!is_label(keyword)) {
      skip_unknown(keyword);
    }
  }

  void skip_unknown(std::string_view keyword) {
    if (unknown_lines_++ == 0) first_unknown_ = keyword;
    if (source_.is_strict) rows_.fail(unknown_statement());
  }

  std::string unknown_statement() const {
    return "an OBJ file has no lines that start with " + in_quotes(first_unknown_);
  }

  void read_vertex() {
    const std::size_t row = mesh().positions.size();
    const auto coordinate = [&] { return "a coordinate of vertex " + std::to_string(row + 1); };
    const auto color_name = [&] { return "the color of vertex " + std::to_string(row + 1); };
    const std::size_t words = rows_.words_left();
    if (words != 3 && words != 4 && words != 6) {
      rows_.fail("vertex " + std::to_string(row + 1) + " has " + counted(words, "number") +
                 "; 3 are needed, 4 with a weight or 6 with a color");
    }
    if (row + 1 >= no_index) rows_.fail(too_many_vertices);
    Vec3& position = mesh().positions.emplace_back();
    for (const Eigen::Index axis : {0, 1, 2})
      position[axis] = rows_.number_or_nan<double>(coordinate);
    if (words == 4 && rows_.number_or_nan<double>(coordinate) != 1) ++weights_;
    if (words != 6) return;
    ColorRows::Color color = ColorRows::no_color;
    for (std::size_t i = 0; i < 3; ++i) color[i] = rows_.number_or_nan<double>(color_name);
    colors_.set(row, color, 3);
  }

  void read_texture_point() {
    const auto name = [] { return std::string("a texture coordinate"); };
    const auto u = rows_.number<double>(name);
    const double v = rows_.has_more() ? rows_.number<double>(name) : 0;
    if (rows_.has_more() && rows_.number<double>(name) != 0) ++third_texture_numbers_;
    texture_.add_point(u, v);
    ++texture_points_;
  }

  /// If the statement is a label (`g`, `o` or `usemtl`), reads it and returns true.
  bool is_label(std::string_view keyword) {
    for (std::size_t i = 0; i < obj_label_kinds.size(); ++i) {
      if (keyword != obj_label_kinds[i].keyword) continue;
      labels_[i].set(polygons_.rows(), rows_.skip_row());
      return true;
    }
    return false;
  }

  void read_face() {
    corners_.clear();
    texture_corners_.clear();
    while (rows_.has_more()) corners_.push_back(read_corner(rows_.word()));
    texture_.add_face(polygons_.rows(), corners_, texture_corners_);
    polygons_.add(corners_);
  }

  /// Reads a corner of a face: `vertex`, `vertex/texture`, `vertex//normal` or
  /// `vertex/texture/normal`. Indices start at 1; negative indices are relative to the last vertex
  /// read.
  Index read_corner(std::string_view word) {
    const char* first = word.data();
    const char* last = first + word.size();
    std::int64_t index = 0;
    const bool is_number = parse_number(first, last, index) == Parsed::ok;
    const bool has_others = first != last && *first == '/';
    const std::string_view others(first, static_cast<std::size_t>(last - first));
    const bool is_clean = others.find_first_not_of("/0123456789-") == std::string_view::npos;
    if (!is_number || !is_clean || !(first == last || has_others)) {
      rows_.fail("a corner of " + face_name() + " is not an index: " + in_quotes(word));
    }
    texture_corners_.push_back(has_others ? texture_number(first + 1, last) : 0);
    const auto known = static_cast<std::int64_t>(mesh().positions.size());
    const std::int64_t absolute = index < 0 ? known + index : index - 1;
    if (index == 0 || absolute < 0 || absolute >= no_index) rows_.fail(out_of_range(index));
    remember_largest(static_cast<Index>(absolute));
    return static_cast<Index>(absolute);
  }

  static std::int64_t texture_number(const char* first, const char* last) {
    std::int64_t number = 0;
    const bool is_number = parse_number(first, last, number) == Parsed::ok;
    return is_number && (first == last || *first == '/') ? number : 0;
  }

  /// Stores the largest vertex index. A face may precede its vertices, so its indices can only be
  /// checked at the end of the file.
  void remember_largest(Index index) {
    if (largest_index_place_ && index <= largest_index_) return;
    largest_index_ = index;
    largest_index_place_ = rows_.place();
    largest_index_face_ = polygons_.rows() + 1;
  }

  std::string face_name() const { return "face " + std::to_string(polygons_.rows() + 1); }

  std::string out_of_range(std::int64_t index) {
    const std::uint32_t face = index > 0 && index == std::int64_t{largest_index_} + 1
                                   ? largest_index_face_
                                   : polygons_.rows() + 1;
    return "face " + std::to_string(face) + " has vertex index " + std::to_string(index) +
           ", but " + there_are(mesh().positions.size(), "vertex");
  }

  /// Adds color columns. If all values are multiples of 1/255, they come from bytes, and become
  /// bytes.
  void add_colors() {
    Columns& columns = mesh().vertex_columns;
    colors_.see_word(".");
    colors_.add_columns(mesh().positions.size(), columns);
    if (colors_.missing_rows() > 0) {
      result_.notes.push_back("obj: " + counted(colors_.missing_rows(), "point") +
                              " without a color made white");
    }
    note_zeroed(colors_.bad_rows(), "color", "obj", result_.notes);
    const auto is_byte = [](double value) {
      return value >= 0 && value <= 1 && std::round(value * 255) / 255 == value;
    };
    const bool are_bytes =
        std::all_of(columns.columns.begin(), columns.columns.end(), [&](const Column& column) {
          return std::all_of(column.values.begin(), column.values.end(), is_byte);
        });
    if (!are_bytes) return;
    for (Column& column : columns.columns) {
      column.type = Scalar::uint8;
      for (double& value : column.values) value = std::round(value * 255);
    }
  }

  /// Adds the comments of the file. Drops those that OBJ expresses as statements, because they
  /// describe an earlier version of the mesh.
  void add_comments() {
    std::vector<std::string>& comments = result_.document.style.comments;
    comments = std::move(rows_.comments);
    std::erase_if(comments, is_obj_comment);
    for (const std::string& name : libraries_)
      if (!name.empty()) comments.push_back(std::string(obj_library_comment) + name);
  }

  void add_face_columns() {
    texture_.move_into(mesh(), polygons_.rows(), result_.notes);
    for (std::size_t i = 0; i < obj_label_kinds.size(); ++i)
      labels_[i].move_into(obj_label_kinds[i], polygons_.rows(), result_.document);
  }

  void add_notes() {
    std::vector<std::string>& notes = result_.notes;
    if (!texture_.is_used() && texture_points_ > 0) ignored_["vt"] = texture_points_;
    if (third_texture_numbers_ > 0) {
      notes.push_back("obj: third numbers of " +
                      counted(third_texture_numbers_, "texture coordinate") + " left out");
    }
    for (const auto& [keyword, count] : ignored_) {
      notes.push_back("obj: " + counted(count, "line") + " '" + std::string(keyword) +
                      "' left out");
    }
    if (unknown_lines_ > 0) {
      notes.push_back("obj: " + counted(unknown_lines_, "unknown statement") +
                      " skipped; the first is " + in_quotes(first_unknown_) + " in line " +
                      std::to_string(source_.line_of(first_unknown_.data())));
    }
    if (weights_ > 0)
      notes.push_back("obj: weights of " + counted(weights_, "vertex") + " left out");
    if (rows_.trailing_comments > 0) {
      notes.push_back("obj: " + counted(rows_.trailing_comments, "comment") +
                      " after data left out");
    }
  }

  const Source& source_;
  TextRows rows_;
  FaceRows polygons_;
  ColorRows colors_;
  ObjTexture texture_;
  std::array<ObjLabelReader, obj_label_kinds.size()> labels_;
  std::vector<std::string> libraries_;
  std::vector<Index> corners_;
  std::vector<std::int64_t> texture_corners_;
  std::size_t texture_points_ = 0;
  std::size_t third_texture_numbers_ = 0;
  Index largest_index_ = 0;
  const char* largest_index_place_ = nullptr;
  std::uint32_t largest_index_face_ = 0;
  std::map<std::string_view, std::size_t> ignored_;
  std::size_t unknown_lines_ = 0;
  std::string_view first_unknown_;
  std::size_t weights_ = 0;
  ReadResult result_;
};

}  // namespace

ReadResult read_obj(const Source& source) {
  // Remove zero bytes at the end: some programs write the terminating zero of a C string.
  const std::size_t size = source.bytes.find_last_not_of('\0') + 1;
  if (size < source.bytes.size() && source.is_strict)
    source.fail_at_byte(source.begin() + size, "the text ends in a byte of value 0");
  const Source text{source.bytes.substr(0, size), source.name, source.is_strict,
                    source.keeps_polygons};
  ReadResult result = ObjReader(text).read();
  if (size < source.bytes.size())
    result.notes.push_back("obj: " + counted(source.bytes.size() - size, "byte") +
                           " of value 0 at the end skipped");
  return result;
}

}  // namespace transformesh
