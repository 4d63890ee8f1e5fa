#include "output_style.h"

#include "tm/io/mesh_io.h"

namespace transformesh::tool {
namespace {

bool is_pipe_format(Format format) {
  return format == Format::ply_little || format == Format::ply_big || format == Format::ply_ascii ||
         format == Format::off;
}

bool is_stl(Format format) { return format == Format::stl_ascii || format == Format::stl_binary; }

Scalar output_coordinate(const Style& style, const CommonOptions& options) {
  if (options.as_float || is_stl(style.format)) return Scalar::float32;
  const bool is_always_double = style.format == Format::off || style.format == Format::obj;
  return options.as_double || is_always_double ? Scalar::float64 : style.coordinate;
}

}  // namespace

Format output_format(Format input, const CommonOptions& options) {
  if (options.format == "ply") return Format::ply_little;
  if (options.format == "ply-ascii") return Format::ply_ascii;
  if (options.format == "ply-be") return Format::ply_big;
  if (options.format == "off") return Format::off;
  Format named = input;
  if (format_of_name(options.output, input, named)) return named;
  return is_pipe_format(input) ? input : Format::ply_little;
}

std::size_t apply_output_style(Document& document, const CommonOptions& options) {
  Style& style = document.style;
  style.format = output_format(style.format, options);
  std::size_t collapsed = 0;
  const Scalar coordinate = output_coordinate(style, options);
  if (coordinate == Scalar::float32 && style.coordinate != Scalar::float32) {
    collapsed = round_positions(document.mesh, Scalar::float32);
  }
  style.coordinate = coordinate;
  return collapsed;
}

bool is_text(Format format) {
  return format == Format::ply_ascii || format == Format::off || format == Format::obj ||
         format == Format::stl_ascii;
}

const char* format_name(Format format) {
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
    default:
      return "ply";
  }
}

}  // namespace transformesh::tool
