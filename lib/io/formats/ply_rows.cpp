#include "io/formats/ply_rows.h"

#include <algorithm>

#include "io/document/scalar.h"
#include "io/document/scalar_bytes.h"
#include "support/counted.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Number of faces read between two checks of the memory in use. Each face may load some pages of 4
/// KB. With 16 times as many faces, a mesh with vertices in random order would load 1 GB between
/// two checks.
constexpr std::size_t faces_between_releases = 1024;

double load(Scalar type, const char* from, bool is_swapped) {
  return with_scalar(type, [&](auto zero) {
    return static_cast<double>(load_scalar<decltype(zero)>(from, is_swapped));
  });
}

void store(Scalar type, double value, bool is_swapped, std::string& bytes) {
  with_scalar(type, [&](auto zero) {
    const auto scalar = to_scalar<decltype(zero)>(value);
    bytes.resize(bytes.size() + sizeof(scalar));
    store_scalar(bytes.data() + bytes.size() - sizeof(scalar), scalar, is_swapped);
  });
}

bool is_corner_list_property(const PlyProperty& property) {
  return property.count_type &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Returns the size of a property in bytes. A list counts as three corners.
std::size_t size_of(const PlyProperty& property) {
  if (!property.count_type) return byte_size(property.type);
  return byte_size(*property.count_type) + 3 * byte_size(property.type);
}

}  // namespace

PlyRows::PlyRows(const std::string& path) : file_(path), source_{file_.bytes(), path} {
  if (!source_.bytes.starts_with("ply")) source_.fail("only binary PLY can be read row by row");
  header_ = read_ply_header(source_);
  if (header_.style.format == Format::ply_ascii)
    source_.fail("only binary PLY can be read row by row, but this file is text");
  is_swapped_ = (header_.style.format == Format::ply_little) != host_is_little;
  place_tables();
  find_coordinates();
  find_corners();
}

PlyRows::Table& PlyRows::table_of(const std::string& name) {
  if (name == "vertex") return vertices_;
  if (name == "face") return faces_;
  source_.fail("only vertices and faces can be read row by row, not the element " +
               in_quotes(name));
}

void PlyRows::place_tables() {
  std::size_t place = header_.size;
  for (std::size_t i = 0; i < header_.elements.size(); ++i) {
    const PlyElement& element = header_.elements[i];
    Table& table = table_of(element.name);
    table.element = i;
    for (const PlyProperty& property : element.properties) {
      if (property.count_type && (element.name != "face" || !is_corner_list_property(property)))
        source_.fail("the list " + in_quotes(property.name) + " cannot be read row by row");
      table.stride += size_of(property);
    }
    if (element.rows >= no_index || element.rows > source_.bytes.size())
      source_.fail("the header announces " + std::to_string(element.rows) + " rows of element " +
                   in_quotes(element.name) + ", but the file ends before them");
    table.count = static_cast<std::size_t>(element.rows);
    table.first = source_.begin() + place;
    place += table.count * table.stride;
  }
  if (!vertices_.first || !faces_.first) source_.fail("the PLY header has no vertices or no faces");
  if (place != source_.bytes.size())
    source_.fail("the header announces " + counted(place, "byte") +
                 " of triangles, but there are " + std::to_string(source_.bytes.size()) +
                 ": the file is cut off, has polygons, or its header is wrong");
}

void PlyRows::find_coordinates() {
  std::array<bool, 3> is_found{};
  std::size_t offset = 0;
  for (const PlyProperty& property : vertex_element().properties) {
    const std::size_t axis = std::string_view("xyz").find(property.name);
    if (property.name.size() == 1 && axis < 3) {
      is_found[axis] = true;
      axis_offset_[axis] = offset;
      axis_type_[axis] = property.type;
    }
    offset += size_of(property);
  }
  if (is_found != std::array{true, true, true})
    source_.fail("the vertices need the properties x, y and z");
}

void PlyRows::find_corners() {
  const auto& properties = face_element().properties;
  const auto list = std::find_if(properties.begin(), properties.end(), is_corner_list_property);
  if (list == properties.end()) source_.fail("the faces need a property list vertex_indices");
  if (std::find_if(list + 1, properties.end(), is_corner_list_property) != properties.end())
    source_.fail("the faces have two lists of corners");
  if (is_floating(list->type))
    source_.fail("face property " + in_quotes(list->name) + " must be a list of integers");
  list_ = static_cast<std::size_t>(list - properties.begin());
  for (auto before = properties.begin(); before != list; ++before) list_offset_ += size_of(*before);
}

Scalar PlyRows::coordinate() const {
  const bool are_floats = std::all_of(axis_type_.begin(), axis_type_.end(),
                                      [](Scalar type) { return type == Scalar::float32; });
  return are_floats ? Scalar::float32 : Scalar::float64;
}

Vec3 PlyRows::position(std::size_t vertex) const {
  const char* row = vertices_.row(vertex);
  Vec3 position;
  for (std::size_t i = 0; i < 3; ++i)
    position[static_cast<Eigen::Index>(i)] =
        load(axis_type_[i], row + axis_offset_[i], is_swapped_);
  if (!position.allFinite())
    source_.fail_at_byte(
        row, "vertex " + std::to_string(vertex) + " has a coordinate that is not a finite number");
  return position;
}

Face PlyRows::face(std::size_t face) const {
  if (++reads_ % faces_between_releases == 0) file_.release();
  const PlyProperty& list = face_element().properties[list_];
  const char* place = faces_.row(face) + list_offset_;
  if (load(*list.count_type, place, is_swapped_) != 3)
    source_.fail_at_byte(place, "face " + std::to_string(face) +
                                    " is not a triangle: all rows must have the same size");
  place += byte_size(*list.count_type);
  Face corners;
  for (Index& corner : corners) {
    const double index = load(list.type, place, is_swapped_);
    if (!(index >= 0 && index < static_cast<double>(vertices_.count)))
      source_.fail_at_byte(place, "face " + std::to_string(face) + " has vertex index " +
                                      std::to_string(static_cast<long>(index)) + ", but " +
                                      there_are(vertices_.count, "vertex"));
    corner = static_cast<Index>(index);
    place += byte_size(list.type);
  }
  return corners;
}

Triangle PlyRows::triangle(const Face& face) const {
  return {position(face[0]), position(face[1]), position(face[2])};
}

void PlyRows::append_vertex(std::size_t vertex, std::string& bytes) const {
  bytes.append(vertices_.row(vertex), vertices_.stride);
}

void PlyRows::append_face(std::size_t face, const Face& corners, Scalar index_type,
                          std::string& bytes) const {
  const PlyProperty& list = face_element().properties[list_];
  const char* row = faces_.row(face);
  const std::size_t before = list_offset_ + byte_size(*list.count_type);
  const std::size_t behind = before + 3 * byte_size(list.type);
  bytes.append(row, before);
  for (const Index corner : corners) store(index_type, corner, is_swapped_, bytes);
  bytes.append(row + behind, faces_.stride - behind);
}

std::string PlyRows::header_text(const std::vector<std::string>& comments, std::size_t vertices,
                                 std::size_t faces, Scalar index_type) const {
  Style style = header_.style;
  style.comments = comments;
  std::vector<PlyElement> elements{vertex_element(), face_element()};
  elements[0].rows = vertices;
  elements[1].rows = faces;
  elements[1].properties[list_].type = index_type;
  return ply_header_text(style, elements);
}

}  // namespace transformesh
