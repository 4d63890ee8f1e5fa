/// PLY (Greg Turk, "The PLY Polygon File Format", Stanford, 1994): ASCII and both binary encodings.
#pragma once

#include <optional>

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

struct PlyProperty {
  std::string name;
  Scalar type = Scalar::float32;
  std::optional<Scalar> count_type;  ///< type of the length of lists, if the property is a list
};

struct PlyElement {
  std::string name;
  std::uint64_t rows = 0;  ///< number of rows, as stated in the header
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  Style style;  ///< encoding, comments and names of elements and types
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< size of the header in bytes, so that the data start there
  /// Number of lines that were read as comments although they lack the keyword `comment`.
  std::size_t unmarked_comments = 0;
};

/// Reads only the header of a PLY file. Throws InputError that names the line of an error.
PlyHeader read_ply_header(const Source& source);

/// Returns the text of a header with the format, comments and type names of the style.
std::string ply_header_text(const Style& style, const std::vector<PlyElement>& elements);

/// Reads PLY as read_mesh() does. write_ply() writes PLY as write_mesh() does; its argument
/// `outlines` is MergedPolygons::outlines.
ReadResult read_ply(const Source& source);
WriteResult write_ply(const Document& document, const Column* outlines = nullptr);

}  // namespace transformesh
