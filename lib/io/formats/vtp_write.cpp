#include <algorithm>

#include "io/document/losses.h"
#include "io/document/scalar.h"
#include "io/document/scalar_bytes.h"
#include "io/document/unit.h"
#include "io/formats/column_groups.h"
#include "io/formats/vtp.h"
#include "io/streams/text_buffer.h"
#include "support/base64.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

/// True if all characters are printable ASCII. Names with other characters could give invalid XML.
bool is_printable(std::string_view name) {
  return std::all_of(name.begin(), name.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

std::string escaped_attribute(std::string_view name) {
  std::string text;
  for (const char c : name) {
    if (c == '&' || c == '<' || c == '>' || c == '"') {
      text += "&#" + std::to_string(int{c}) + ';';
    } else {
      text += c;
    }
  }
  return text;
}

const char* type_name(Scalar type) {
  switch (type) {
    case Scalar::int8:
      return "Int8";
    case Scalar::uint8:
      return "UInt8";
    case Scalar::int16:
      return "Int16";
    case Scalar::uint16:
      return "UInt16";
    case Scalar::int32:
      return "Int32";
    case Scalar::uint32:
      return "UInt32";
    case Scalar::float32:
      return "Float32";
    default:
      return "Float64";
  }
}

/// Returns the number of components that each row of a column has. Returns 0 if rows have different
/// numbers of components.
std::size_t components_of(const Column& column, std::size_t rows) {
  if (!column.list_count_type) return 1;
  const std::size_t width = column.values.size() / rows;
  for (std::size_t row = 0; row < rows; ++row)
    if (column.list_offsets[row + 1] - column.list_offsets[row] != width) return 0;
  return width;
}

class VtpWriter {
 public:
  explicit VtpWriter(const Document& document) : document_(document), mesh_(document.mesh) {}

  WriteResult write() {
    const bool has_faces = !mesh_.faces.empty();
    const std::size_t points = mesh_.positions.size();
    text_.add(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n<Piece");
    add_count("NumberOfPoints", points);
    add_count("NumberOfVerts", has_faces ? 0 : points);
    add_count("NumberOfLines", 0);
    add_count("NumberOfStrips", 0);
    add_count("NumberOfPolys", mesh_.faces.size());
    text_.add(">\n");
    Keeps keeps{"VTP", {}, {}, 0};
    keeps.vertex_columns = add_columns("PointData", mesh_.vertex_columns, points);
    keeps.face_columns = add_columns("CellData", mesh_.face_columns, mesh_.faces.size());
    add_points();
    has_faces ? add_cells("Polys", mesh_.faces.size(), 3) : add_cells("Verts", points, 1);
    text_.add("</Piece>\n</PolyData>\n</VTKFile>\n");
    WriteResult result{text_.take(), losses(document_, keeps)};
    note_lost_unit(document_, "vtp", "", result.notes);
    return result;
  }

 private:
  using Names = std::vector<std::string_view>;

  void add_count(std::string_view name, std::size_t count) {
    add_attribute(name, std::to_string(count));
  }

  void add_attribute(std::string_view name, std::string_view value) {
    for (const std::string_view part : {std::string_view(" "), name, std::string_view("=\"")})
      text_.add(part);
    text_.add(value);
    text_.add('"');
  }

  /// Adds a DataArray of type T. Its number i is value(i).
  template <class T, class Value>
  void add_array(const char* type, std::string_view name, std::size_t components, std::size_t size,
                 const Value& value) {
    constexpr bool swapped = !host_is_little;
    std::string bytes(sizeof(std::uint64_t) + sizeof(T) * size, '\0');
    store_scalar(bytes.data(), std::uint64_t{sizeof(T) * size}, swapped);
    char* to = bytes.data() + sizeof(std::uint64_t);
    for (std::size_t i = 0; i < size; ++i) {
      store_scalar(to, static_cast<T>(value(i)), swapped);
      to += sizeof(T);
    }
    text_.add("<DataArray");
    add_attribute("type", type);
    add_attribute("Name", escaped_attribute(name));
    add_count("NumberOfComponents", components);
    add_attribute("format", "binary");
    text_.add(">\n");
    text_.add(base64(bytes));
    text_.add("\n</DataArray>\n");
  }

  /// Adds the columns of a group, which have one type, as the components of one array.
  void add_group(std::string_view name, const ColumnGroup& group, std::size_t components) {
    const std::size_t width = group.size();
    const Scalar type = group[0]->type;
    with_scalar(type, [&](auto zero) {
      using T = decltype(zero);
      this->add_array<T>(
          type_name(type), name, components, width * group[0]->values.size(),
          [&](std::size_t i) { return to_scalar<T>(group[i % width]->values[i / width]); });
    });
  }

  /// Adds columns as arrays. Returns the names of the columns that the format can represent.
  Names add_columns(const std::string& element, const Columns& columns, std::size_t rows) {
    Names kept;
    if (rows == 0) {  // without faces, cells are points, which have other rows than face columns
      for (const Column& column : columns.columns) kept.push_back(column.name);
      return kept;
    }
    std::string roles;
    std::vector<std::pair<std::string_view, ColumnGroup>> groups;
    const auto add = [&](std::string_view role, std::string_view name, const ColumnGroup& group) {
      if (group.empty() || columns.find(name) != nullptr) return;
      groups.emplace_back(name, group);
      for (const Column* column : group) kept.push_back(column->name);
      roles.append(" ").append(role).append("=\"").append(name).append("\"");
    };
    const ColumnGroup colors = color_group(columns);
    add("Normals", "Normals", normal_group(columns));
    add("Scalars", colors.size() == 4 ? "RGBA" : "RGB", colors);
    if (element == "PointData") add("TCoords", "TCoords", texture_group(columns));
    text_.add('<' + element + roles + ">\n");
    for (const auto& [name, group] : groups) add_group(name, group, group.size());
    for (const Column& column : columns.columns) {
      if (std::find(kept.begin(), kept.end(), column.name) != kept.end()) continue;
      const std::size_t components = components_of(column, rows);
      if (components == 0 || !is_printable(column.name)) continue;
      add_group(column.name, {&column}, components);
      kept.push_back(column.name);
    }
    text_.add("</" + element + ">\n");
    return kept;
  }

  void add_points() {
    const bool is_single = document_.style.coordinate == Scalar::float32;
    const auto coordinate = [&](std::size_t i) {
      return mesh_.positions[i / 3][static_cast<Eigen::Index>(i % 3)];
    };
    const std::size_t size = 3 * mesh_.positions.size();
    text_.add("<Points>\n");
    is_single ? add_array<float>("Float32", "Points", 3, size, coordinate)
              : add_array<double>("Float64", "Points", 3, size, coordinate);
    text_.add("</Points>\n");
  }

  /// Adds the faces as cells. If there are none, adds one cell per point.
  void add_cells(const std::string& kind, std::size_t cells, std::size_t corners) {
    text_.add('<' + kind + ">\n");
    add_array<std::int64_t>("Int64", "connectivity", 1, cells * corners, [&](std::size_t i) {
      return corners == 1 ? i : std::size_t{mesh_.faces[i / 3][i % 3]};
    });
    add_array<std::int64_t>("Int64", "offsets", 1, cells,
                            [&](std::size_t i) { return corners * (i + 1); });
    text_.add("</" + kind + ">\n");
  }

  const Document& document_;
  const Mesh& mesh_;
  TextBuffer text_;
};

}  // namespace

WriteResult write_vtp(const Document& document) { return VtpWriter(document).write(); }

}  // namespace transformesh
