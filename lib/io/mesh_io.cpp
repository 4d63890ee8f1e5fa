#include "io/mesh_io.h"

#include <algorithm>
#include <utility>

#include "io/document/scalar.h"
#include "io/formats/detect_format.h"
#include "io/formats/glb.h"
#include "io/formats/obj.h"
#include "io/formats/off.h"
#include "io/formats/ply.h"
#include "io/formats/stl.h"
#include "io/formats/vtp.h"
#include "io/streams/atomic_file.h"
#include "io/streams/streams.h"
#include "mesh/coordinate_spacing.h"
#include "support/error.h"

namespace transformesh {
namespace {

/// In the header of binary STL the mark is a part of the name.
std::string_view without_byte_order_mark(std::string_view bytes) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  const bool is_marked = bytes.starts_with(mark) && !is_binary_stl_by_size(bytes);
  return is_marked ? bytes.substr(mark.size()) : bytes;
}

void check_columns(const Columns& columns, std::size_t rows, const std::string& element) {
  for (const Column& column : columns.columns) {
    const bool fits = column.list_count_type
                          ? column.list_offsets.size() == rows + 1 &&
                                column.list_offsets.back() == column.values.size()
                          : column.values.size() == rows;
    if (fits) continue;
    std::string message = element + " property '" + column.name;
    throw GoalError(message.append("' does not have one value for each ").append(element));
  }
}

void check_finite(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.positions[i].allFinite()) continue;
    throw GoalError("vertex " + std::to_string(i) +
                    " would have a coordinate that is not a finite number: no mesh is written");
  }
}

void check_writable(const Document& document) {
  check_finite(document.mesh);
  check_columns(document.mesh.vertex_columns, document.mesh.positions.size(), "vertex");
  check_columns(document.mesh.face_columns, document.mesh.faces.size(), "face");
  for (const OtherElement& other : document.other_elements) {
    check_columns(other.columns, other.rows, other.name);
  }
}

void check_float_range(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const bool fits = mesh.positions[i].cast<float>().allFinite();
    if (fits) continue;
    throw GoalError("vertex " + std::to_string(i) +
                    " has a coordinate too large for float: write double");
  }
}

void round_columns(Columns& columns) {
  for (Column& column : columns.columns) {
    if (column.type == Scalar::float64) continue;
    with_scalar(column.type, [&](auto zero) {
      for (double& value : column.values) {
        const volatile auto written = to_scalar<decltype(zero)>(value);  // as in round_to_single()
        value = static_cast<double>(written);
      }
    });
  }
}

bool is_ply(Format format) {
  return format == Format::ply_ascii || format == Format::ply_little || format == Format::ply_big;
}

// In lower case, with the dot; empty without one.
std::string extension_of(std::string_view name) {
  std::string extension(name.substr(std::min(name.rfind('.'), name.size())));
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return extension;
}

}  // namespace

ReadResult read_mesh(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  const Source source{without_byte_order_mark(bytes), name, options.strict};
  switch (detect_format(source)) {
    case FileKind::ply:
      return read_ply(source);
    case FileKind::off:
      return read_off(source);
    case FileKind::obj:
      return read_obj(source);
    case FileKind::stl_ascii:
      return read_stl_text(source);
    default:
      return read_stl_binary(source);
  }
}

WriteResult write_mesh(const Document& document) {
  check_writable(document);
  switch (document.style.format) {
    case Format::off:
      return write_off(document);
    case Format::obj:
      return write_obj(document);
    case Format::glb:
      check_float_range(document.mesh);
      return write_glb(document);
    case Format::vtp:
      if (document.style.coordinate == Scalar::float32) check_float_range(document.mesh);
      return write_vtp(document);
    case Format::stl_ascii:
    case Format::stl_binary:
      check_float_range(document.mesh);
      return write_stl(document);
    default:
      if (document.style.coordinate == Scalar::float32) check_float_range(document.mesh);
      return write_ply(document);
  }
}

Mesh read_mesh_file(const std::string& path) {
  const Bytes bytes = read_all(path);
  return read_mesh(bytes.view(), input_name(path)).document.mesh;
}

void write_mesh_file(const std::string& path, const Mesh& mesh) {
  Document document;
  document.mesh = mesh;
  document.style.format = format_for(Format::ply_little, "", path);
  write_file(path, write_mesh(document).bytes);
}

Format format_for(Format input, std::string_view wanted, std::string_view name) {
  if (wanted == "ply") return Format::ply_little;
  if (wanted == "ply-ascii") return Format::ply_ascii;
  if (wanted == "ply-be") return Format::ply_big;
  const std::string extension = wanted.empty() ? extension_of(name) : '.' + std::string(wanted);
  if (extension == ".off") return Format::off;
  if (extension == ".obj") return Format::obj;
  if (extension == ".glb") return Format::glb;
  if (extension == ".vtp") return Format::vtp;
  const bool is_text_stl = input == Format::stl_ascii;
  if (extension == ".stl") return is_text_stl ? Format::stl_ascii : Format::stl_binary;
  if (extension == ".ply") return is_ply(input) ? input : Format::ply_little;
  return is_ply(input) || input == Format::off ? input : Format::ply_little;
}

const std::vector<std::string>& written_endings() {
  static const std::vector<std::string> endings{".ply", ".off", ".obj", ".stl", ".glb", ".vtp"};
  return endings;
}

std::string unknown_ending(std::string_view name, const std::vector<std::string>& known) {
  constexpr std::size_t longest = 5;
  const std::string_view file = name.substr(name.rfind('/') + 1);
  const std::string ending = extension_of(file);
  const bool is_ending =
      ending.size() > 1 && ending.size() <= longest && ending.size() < file.size();
  const bool is_known = std::find(known.begin(), known.end(), ending) != known.end();
  const bool has_letter =
      std::any_of(ending.begin(), ending.end(), [](char c) { return c >= 'a' && c <= 'z'; });
  return is_ending && has_letter && !is_known ? ending : "";
}

std::size_t set_format(Document& document, Format format, std::optional<Scalar> coordinate) {
  Style& style = document.style;
  style.format = format;
  if (holds_floats(format)) coordinate = Scalar::float32;
  if (!coordinate && !is_ply(format)) coordinate = Scalar::float64;
  const Scalar before = std::exchange(style.coordinate, coordinate.value_or(style.coordinate));
  return before == style.coordinate ? 0 : round_positions(document.mesh, style.coordinate);
}

const char* name_of(Format format) {
  switch (format) {
    case Format::ply_ascii:
      return "ply-ascii";
    case Format::ply_big:
      return "ply-be";
    case Format::off:
      return "off";
    case Format::obj:
      return "obj";
    case Format::stl_ascii:
    case Format::stl_binary:
      return "stl";
    case Format::glb:
      return "glb";
    case Format::vtp:
      return "vtp";
    default:
      return "ply";
  }
}

bool holds_floats(Format format) {
  return format == Format::stl_ascii || format == Format::stl_binary || format == Format::glb;
}

bool is_text(Format format) {
  return format == Format::ply_ascii || format == Format::off || format == Format::obj ||
         format == Format::stl_ascii;
}

std::size_t round_positions(Mesh& mesh, Scalar coordinate) {
  if (coordinate != Scalar::float32) return 0;
  check_float_range(mesh);
  const std::vector<Vec3> before = mesh.positions;
  for (Vec3& position : mesh.positions) {
    for (double& x : position) x = round_to_single(x);
  }
  const RoundingLoss loss = rounding_loss(mesh, before);
  if (2 * (loss.collapsed + loss.turned) > mesh.faces.size()) {
    throw GoalError(
        "floats have no digits for this mesh: most of its faces collapse or turn; write double, in "
        "PLY, OFF or OBJ, or move it to the origin before");
  }
  return loss.collapsed;
}

void round_as_written(Document& document) {
  check_writable(document);
  if (document.style.coordinate == Scalar::float32) {
    check_float_range(document.mesh);
    for (Vec3& position : document.mesh.positions) position = position.unaryExpr(&round_to_single);
  }
  round_columns(document.mesh.vertex_columns);
  round_columns(document.mesh.face_columns);
  for (OtherElement& other : document.other_elements) round_columns(other.columns);
}

}  // namespace transformesh
