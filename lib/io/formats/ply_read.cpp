#include <algorithm>

#include "io/document/scalar.h"
#include "io/document/scalar_bytes.h"
#include "io/formats/finite_values.h"
#include "io/formats/ply_table.h"
#include "support/counted.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

class PlyReader {
 public:
  explicit PlyReader(const Source& source)
      : source_(source), header_(read_ply_header(source)), rows_(source, header_.size, {}) {}

  ReadResult read() {
    place_ = source_.begin() + header_.size;
    if (header_.unmarked_comments > 0)
      result_.notes.push_back("ply: " + counted(header_.unmarked_comments, "line") +
                              " of the header without a keyword taken as a comment");
    result_.document.style = header_.style;
    vertex_count_ = find_vertices().rows;
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else {
        read_other(element);
      }
    }
    finish_faces();
    note_rest();
    return std::move(result_);
  }

 private:
  const PlyElement& find_vertices() const {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") return element;
    }
    source_.fail("the PLY header has no element 'vertex'");
  }

  void read_vertices(const PlyElement& element) {
    PlyTable table = make_table(element);
    std::array<bool, 3> found{};
    Style& style = result_.document.style;
    style.coordinate = Scalar::float32;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      const std::size_t axis = std::string_view("xyz").find(property.name);
      if (property.name.size() != 1 || axis > 2) continue;
      if (property.count_type)
        source_.fail("vertex property " + in_quotes(property.name) + " must not be a list");
      if (found[axis])
        source_.fail("vertex property " + in_quotes(property.name) + " is listed twice");
      found[axis] = true;
      table.targets[i] = {PlyTable::Target::coordinate, axis};
      if (property.type != Scalar::float32) style.coordinate = Scalar::float64;
      places.push_back(i);
    }
    if (element.rows > 0 && places.size() < 3) {
      source_.fail("the vertices need the properties x, y and z");
    }
    note_coordinates(element, places);
    style.position_column = places.empty() ? 0 : places.front();
    add_columns(table);
    read_rows(table);
    result_.document.mesh.positions = std::move(table.positions);
    zero_values_not_finite(table.columns, source_, "vertex", "ply", result_.notes);
    result_.document.mesh.vertex_columns = std::move(table.columns);
  }

  void note_coordinates(const PlyElement& element, const std::vector<std::size_t>& places) {
    std::string order;
    bool is_integer = false;
    for (const std::size_t i : places) {
      order += element.properties[i].name;
      is_integer = is_integer || !is_floating(element.properties[i].type);
    }
    if (places.size() == 3 && (places.back() - places.front() > 2 || order != "xyz")) {
      result_.notes.emplace_back(
          "ply: the vertex properties x, y and z will be written side by side in this order");
    }
    if (is_integer) result_.notes.emplace_back("ply: integer coordinates become double");
  }

  void read_faces(const PlyElement& element) {
    PlyTable table = make_table(element);
    Style& style = result_.document.style;
    const auto list = std::find_if(
        element.properties.begin(), element.properties.end(), [](const PlyProperty& property) {
          return property.name == "vertex_indices" || property.name == "vertex_index";
        });
    if (list != element.properties.end()) {
      if (!list->count_type || is_floating(list->type)) {
        source_.fail("face property " + in_quotes(list->name) + " must be a list of integers");
      }
      style.face_list = list->name;
      style.face_list_count = *list->count_type;
      style.face_list_index = list->type;
      style.face_list_column = static_cast<std::size_t>(list - element.properties.begin());
      table.targets[style.face_list_column].kind = PlyTable::Target::face_list;
    } else if (element.rows > 0) {
      source_.fail("the faces need a property list vertex_indices");
    }
    add_columns(table);
    read_rows(table);
    zero_values_not_finite(table.columns, source_, "face", "ply", result_.notes);
    result_.document.mesh.face_columns = std::move(table.columns);
    faces_ = std::move(table.polygons);
  }

  /// Moves the faces into the mesh, or the triangles of strips if there are no faces. Called after
  /// the last element, because faces may precede vertices.
  void finish_faces() {
    const bool are_strips = faces_.rows() == 0 && strips_.triangles > 0;
    if (are_strips) {
      faces_ = std::move(strips_.faces);
      result_.document.mesh.face_columns = {};
    }
    faces_.keep_polygons(source_.keeps_polygons && !are_strips);
    faces_.move_into(result_.document.mesh, "ply", result_.notes);
    if (strips_.rows == 0) return;
    result_.notes.push_back("ply: " + counted(strips_.rows, "row") + " of triangle strips " +
                            (are_strips ? "cut into " + counted(strips_.triangles, "triangle")
                                        : "left out, as there are faces"));
  }

  void read_other(const PlyElement& element) {
    PlyTable table = make_table(element);
    add_columns(table);
    read_rows(table);
    if (element.name == "tristrips" && element.rows > 0) return add_strips(table);
    const auto vertices = static_cast<std::size_t>(table.vertex_count);
    result_.document.other_elements.push_back({element.name, static_cast<std::size_t>(element.rows),
                                               std::move(table.columns),
                                               std::array<std::size_t, 3>{vertices, 0, 0}});
  }

  void add_strips(const PlyTable& table) {
    std::vector<std::string>& order = result_.document.style.element_order;
    std::erase(order, "face");
    std::replace(order.begin(), order.end(), std::string("tristrips"), std::string("face"));
    const Column* list = table.columns.find("vertex_indices");
    if (list == nullptr) list = table.columns.find("vertex_index");
    if (list == nullptr || !list->list_count_type || is_floating(list->type))
      source_.fail("the triangle strips need a property list vertex_indices of integers");
    if (table.columns.columns.size() > 1)
      result_.notes.emplace_back("ply: further properties of triangle strips dropped");
    strips_.rows = static_cast<std::size_t>(table.element.rows);
    for (std::size_t row = 0; row < strips_.rows; ++row)
      add_strip(table, row,
                std::span(list->values)
                    .subspan(list->list_offsets[row],
                             list->list_offsets[row + 1] - list->list_offsets[row]));
  }

  /// Adds the triangles of a triangle strip. The index -1 ends a strip. Every second triangle is
  /// reversed. A triangle with a repeated vertex is skipped, but still counts for the alternation.
  void add_strip(const PlyTable& table, std::size_t row, std::span<const double> vertices) {
    std::size_t length = 0;
    std::array<Index, 3> last{};
    for (const double value : vertices) {
      if (value == -1) {
        length = 0;
        continue;
      }
      if (!(value >= 0 && value < static_cast<double>(table.vertex_count)))
        source_.fail(table.bad_index(row, value));
      last = {last[1], last[2], static_cast<Index>(value)};
      if (++length < 3 || is_collapsed(last)) continue;
      strips_.faces.add(length % 2 == 1 ? last : Face{last[1], last[0], last[2]});
      ++strips_.triangles;
    }
  }

  PlyTable make_table(const PlyElement& element) const {
    PlyTable table;
    table.element = element;
    table.targets.resize(element.properties.size());
    table.vertex_count = std::min<std::uint64_t>(vertex_count_, no_index);
    return table;
  }

  /// Creates a column for every property of an element, except coordinates and the list of corners.
  static void add_columns(PlyTable& table) {
    for (std::size_t i = 0; i < table.targets.size(); ++i) {
      if (table.targets[i].kind != PlyTable::Target::column) continue;
      const PlyProperty& property = table.element.properties[i];
      table.targets[i].index = table.columns.columns.size();
      Column& column = table.columns.columns.emplace_back();
      column.name = property.name;
      column.type = property.type;
      column.list_count_type = property.count_type;
      if (column.list_count_type) column.list_offsets.push_back(0);
    }
  }

  void read_rows(PlyTable& table) {
    const bool is_text = header_.style.format == Format::ply_ascii;
    check_claim(table, is_text);
    if (is_text) {
      read_text_rows(rows_, table);
      note_long_rows(table);
    } else {
      const bool swapped = (header_.style.format == Format::ply_little) != host_is_little;
      place_ = read_binary_rows(source_, place_, swapped, table);
    }
  }

  void note_long_rows(const PlyTable& table) {
    if (table.long_rows == 0) return;
    result_.notes.push_back("ply: " + counted(table.long_rows, "row") + " of element " +
                            in_quotes(table.element.name) +
                            " with more values than the header announces, from line " +
                            std::to_string(source_.line_of(table.first_long_row)) +
                            " on; the extra values are left out");
  }

  /// Throws InputError if the remaining bytes cannot contain the number of rows that the header
  /// states. Called before memory is allocated for the rows. In text, each value takes at least a
  /// digit, and each value except the last takes a separator.
  void check_claim(const PlyTable& table, bool is_text) const {
    const char* place = is_text ? rows_.rest() : place_;
    const auto left = static_cast<std::size_t>(source_.end() - place);
    const std::size_t size = is_text ? 2 * table.targets.size() : table.row_size(0);
    const std::uint64_t rows = table.element.rows;
    if (size > 0 && rows > (left + (is_text ? 1 : 0)) / size) {
      source_.fail_at_byte(place, "the header announces " + std::to_string(rows) +
                                      " rows of element " + in_quotes(table.element.name) +
                                      ", but only " + counted(left, "byte") +
                                      " follow: the file is cut off or its header is wrong");
    }
    const bool is_face = table.element.name == "face";
    const Index least_refused = is_face ? no_index / 3 : no_index;
    if (size > 0 && rows >= least_refused) {
      source_.fail("more than " + std::to_string(least_refused - 1) + " rows of element " +
                   in_quotes(table.element.name) +
                   " are not supported: split the input into smaller files");
    }
  }

  void note_rest() {
    if (header_.style.format == Format::ply_ascii) {
      if (rows_.next_row()) result_.notes.emplace_back("ply: data after the last element ignored");
      return;
    }
    if (std::all_of(place_, source_.end(), [](char c) { return c == '\n' || c == '\r'; })) return;
    result_.notes.push_back(
        "ply: " + counted(static_cast<std::size_t>(source_.end() - place_), "byte") +
        " after the last element ignored");
  }

  const Source& source_;
  PlyHeader header_;
  TextRows rows_;                ///< current position in text data
  const char* place_ = nullptr;  ///< current position in binary data
  std::uint64_t vertex_count_ = 0;
  FaceRows faces_;
  struct {
    FaceRows faces;
    std::size_t rows = 0, triangles = 0;
  } strips_;
  ReadResult result_;
};

}  // namespace

std::size_t PlyTable::row_size(std::size_t corner_count) const {
  std::size_t size = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    size += byte_size(property.count_type.value_or(property.type));
    if (targets[i].kind == Target::face_list) size += corner_count * byte_size(property.type);
  }
  return size;
}

std::string PlyTable::row_name(std::size_t row) const {
  if (element.name == "vertex" || element.name == "face") {
    return element.name + ' ' + std::to_string(row);
  }
  return "row " + std::to_string(row) + " of element " + in_quotes(element.name);
}

std::string PlyTable::value_name(std::size_t row, const PlyProperty& property) const {
  return "property " + in_quotes(property.name) + " of " + row_name(row);
}

std::string PlyTable::bad_index(std::size_t row, double index) const {
  return row_name(row) + " has vertex index " + std::to_string(static_cast<long>(index)) +
         ", but " + there_are(vertex_count, "vertex");
}

ReadResult read_ply(const Source& source) { return PlyReader(source).read(); }

}  // namespace transformesh
