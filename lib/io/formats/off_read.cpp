#include <algorithm>
#include <cmath>

#include "io/formats/color_rows.h"
#include "io/formats/face_rows.h"
#include "io/formats/finite_values.h"
#include "io/formats/off.h"
#include "io/formats/text_rows.h"
#include "support/counted.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

/// The properties of vertices that an OFF keyword such as STCNOFF announces.
struct OffVariant {
  bool texture = false;
  bool color = false;
  bool normal = false;
  bool is_known = false;
  std::string_view rest;  ///< text that follows the keyword in the same word
};

bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (text.substr(0, prefix.size()) != prefix) return false;
  text.remove_prefix(prefix.size());
  return true;
}

/// Returns the vertex properties that a keyword announces. Accepts prefix letters in any order:
/// Geomview uses ST C N, MeshLab writes N C ST.
OffVariant off_variant(std::string_view word) {
  OffVariant variant;
  for (;;) {
    if (take_prefix(word, "OFF")) {
      variant.is_known = word.empty() || (word[0] >= '0' && word[0] <= '9');
      variant.rest = word;
      return variant;
    }
    if (take_prefix(word, "ST")) {
      variant.texture = true;
    } else if (take_prefix(word, "C")) {
      variant.color = true;
    } else if (take_prefix(word, "N")) {
      variant.normal = true;
    } else {
      return {};
    }
  }
}

class OffReader {
 public:
  explicit OffReader(const Source& source) : source_(source), rows_(source, 0, {'#', false}) {}

  ReadResult read() {
    Style& style = result_.document.style;
    style.format = Format::off;
    read_header();
    read_vertices();
    read_faces();
    note_rest();
    style.comments = std::move(rows_.comments);
    return std::move(result_);
  }

 private:
  template <class What>
  void need_row(const What& what) {
    if (!rows_.next_row()) rows_.fail("the data ends before " + what());
  }

  void read_header() {
    need_row([] { return std::string("the word OFF"); });
    const std::string_view keyword = rows_.peek();
    variant_ = off_variant(keyword);
    std::string_view glued;
    if (variant_.is_known) {
      rows_.word();
      glued = variant_.rest;
    } else if (keyword.find_first_not_of("0123456789") != std::string_view::npos) {
      rows_.fail("an OFF file starts with the word OFF (or COFF, NOFF, STOFF), not " +
                 in_quotes(keyword));
    }
    if (rows_.peek() == "BINARY")
      rows_.fail("binary OFF is not supported: convert it to text or PLY");
    if (glued.empty() && !rows_.has_more())
      need_row([] { return std::string("the counts of vertices and faces"); });
    vertex_count_ = glued.empty() ? read_count("the count of vertices") : glued_count(glued);
    face_count_ = read_count("the count of faces");
    if (rows_.has_more()) read_count("the count of edges");
    rows_.end_row([] { return std::string("the line of counts"); });
  }

  std::uint64_t read_count(const char* what) {
    return rows_.number<std::uint64_t>([&] { return std::string(what); });
  }

  std::uint64_t glued_count(std::string_view text) {
    const char* first = text.data();
    std::uint64_t count = 0;
    const char* last = first + text.size();
    if (parse_number(first, last, count) != Parsed::ok || first != last) {
      rows_.fail("the count of vertices is not a number: " + in_quotes(text));
    }
    return count;
  }

  void read_vertices() {
    constexpr std::size_t shortest_row = 6;  // bytes of the shortest row: `0 0 0` and a line end
    if (vertex_count_ > source_.bytes.size() / shortest_row + 1 || vertex_count_ >= no_index) {
      rows_.fail("the header announces " + counted(vertex_count_, "vertex") +
                 ", but the file has only " + counted(source_.bytes.size(), "byte") +
                 ": it is cut off or its header is wrong");
    }
    Mesh& mesh = result_.document.mesh;
    const auto count = static_cast<std::size_t>(vertex_count_);
    mesh.positions.resize(count);
    add_announced_columns(count);
    for (row_ = 0; row_ < count; ++row_) {
      need_row([&] { return row_name("vertex") + " of " + std::to_string(count); });
      if (row_ == 0) decide_layout(rows_.words_left());
      read_vertex(mesh);
    }
    zero_values_not_finite(mesh.vertex_columns, source_, "vertex", "off", result_.notes);
    vertex_colors_.add_columns(count, mesh.vertex_columns);
    note_zeroed(vertex_colors_.bad_rows(), "color", "off", result_.notes);
    note_scaled(vertex_colors_);
    note_zeroed(bad_texture_, "texture coordinate", "off", result_.notes);
    for (Column& column : texture_.columns) {
      mesh.vertex_columns.columns.push_back(std::move(column));
    }
  }

  void add_announced_columns(std::size_t count) {
    for (const char* name : {"nx", "ny", "nz"}) {
      if (variant_.normal) result_.document.mesh.vertex_columns.get(name, Scalar::float64, count);
    }
    for (const char* name : {"s", "t"}) {
      if (variant_.texture) texture_.get(name, Scalar::float64, count);
    }
  }

  /// Determines which values of a vertex line are which property. Values of the first vertex that
  /// the header does not announce are a color.
  void decide_layout(std::size_t words) {
    const std::size_t announced = 3 + (variant_.normal ? 3 : 0) + (variant_.texture ? 2 : 0);
    channels_ = words < announced ? 0 : words - announced;
    if (channels_ == 3 || channels_ == 4 || (channels_ == 0 && !variant_.color)) {
      if (channels_ > 0 && !variant_.color) {
        result_.notes.emplace_back("off: " + std::to_string(channels_) +
                                   " further numbers of each vertex are read as its color");
      }
    } else {
      rows_.fail("vertex 0 has " + counted(words, "number") + ", which does not fit the header");
    }
  }

  void read_vertex(Mesh& mesh) {
    for (const Eigen::Index axis : {0, 1, 2}) {
      mesh.positions[row_][axis] = read_value("a coordinate of vertex");
    }
    for (Column& column : mesh.vertex_columns.columns) {
      column.values[row_] = read_value("the normal of vertex");
    }
    if (channels_ > 0) read_color(channels_, vertex_colors_);
    for (Column& column : texture_.columns) {
      const double value = read_value("the texture coordinate of vertex");
      if (std::isnan(value)) ++bad_texture_;
      column.values[row_] = std::isnan(value) ? 0 : value;
    }
    rows_.end_row([&] { return row_name("vertex"); });
  }

  void read_faces() {
    std::vector<Index> corners;
    for (row_ = 0; row_ < face_count_; ++row_) {
      need_row([&] { return row_name("face") + " of " + std::to_string(face_count_); });
      corners.clear();
      const auto name = [&] { return row_name("face"); };
      auto left = rows_.number<std::uint64_t>([&] { return "the number of corners of " + name(); });
      for (; left > 0; --left) {
        const auto index = rows_.number<std::int64_t>([&] { return "a corner of " + name(); });
        if (index < 0 || static_cast<std::uint64_t>(index) >= vertex_count_) {
          rows_.fail(name() + " has vertex index " + std::to_string(index) + ", but " +
                     there_are(vertex_count_, "vertex"));
        }
        corners.push_back(static_cast<Index>(index));
      }
      polygons_.add(corners);
      if (rows_.has_more()) read_face_color();
    }
    Mesh& mesh = result_.document.mesh;
    face_colors_.add_columns(polygons_.rows(), mesh.face_columns);
    note_zeroed(face_colors_.bad_rows(), "color", "off", result_.notes);
    note_scaled(face_colors_);
    polygons_.keep_polygons(source_.keeps_polygons);
    polygons_.move_into(mesh, "off", result_.notes);
  }

  /// Reads a face color as in Geomview: a color index, or three or four channels.
  void read_face_color() {
    const std::size_t words = rows_.words_left();
    if (words == 1 || words == 3 || words == 4) return read_color(words, face_colors_);
    ++strange_faces_;
  }

  void read_color(std::size_t channels, ColorRows& colors) {
    ColorRows::Color color = ColorRows::no_color;
    for (std::size_t i = 0; i < channels; ++i) {
      color[i] = read_value(&colors == &face_colors_ ? "the color of face" : "the color of vertex");
      colors.see_word(rows_.last_word());
    }
    colors.set(row_, color, channels);
  }

  double read_value(const char* what) {
    return rows_.number_or_nan<double>([&] { return row_name(what); });
  }

  std::string row_name(const char* what) const {
    return std::string(what) + ' ' + std::to_string(row_);
  }

  void note_scaled(const ColorRows& colors) {
    if (colors.scaled_rows() > 0)
      result_.notes.push_back("off: " + counted(colors.scaled_rows(), "color") +
                              " of integers up to 255 divided by 255, because others have "
                              "decimals up to 1");
  }

  void note_rest() {
    std::vector<std::string>& notes = result_.notes;
    if (face_colors_.missing_rows() > 0) {
      notes.emplace_back("off: " + counted(face_colors_.missing_rows(), "face") +
                         " without a color made white");
    }
    if (strange_faces_ > 0) {
      notes.emplace_back("off: the numbers after " + counted(strange_faces_, "face") +
                         " are not a color: dropped");
    }
    if (rows_.next_row()) notes.emplace_back("off: data after the last face ignored");
    if (rows_.trailing_comments > 0) {
      notes.emplace_back("off: " + counted(rows_.trailing_comments, "comment") +
                         " after data dropped");
    }
  }

  const Source& source_;
  TextRows rows_;
  OffVariant variant_;
  std::uint64_t vertex_count_ = 0;
  std::uint64_t face_count_ = 0;
  std::size_t row_ = 0;
  std::size_t channels_ = 0;  ///< number of color values per vertex
  ColorRows vertex_colors_;
  Columns texture_;
  FaceRows polygons_;
  ColorRows face_colors_;
  std::size_t strange_faces_ = 0;
  std::size_t bad_texture_ = 0;
  ReadResult result_;
};

}  // namespace

bool is_off_keyword(std::string_view word) { return off_variant(word).is_known; }

ReadResult read_off(const Source& source) { return OffReader(source).read(); }

}  // namespace transformesh
