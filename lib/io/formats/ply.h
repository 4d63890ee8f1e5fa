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
  std::optional<Scalar> count_type;  ///< set if the property is a list
};

struct PlyElement {
  std::string name;
  std::uint64_t rows = 0;  ///< row count stated in the header
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  Style style;  ///< format, comments, names of elements
  std::vector<PlyElement> elements;
  std::size_t size = 0;               ///< offset of the data; bytes
  std::size_t unmarked_comments = 0;  ///< number of comments without the keyword `comment`
};

/// Reads only the header. Throws InputError, with the line.
PlyHeader read_ply_header(const Source& source);

/// Returns the text of a header with the format, comments and type names of the style.
std::string ply_header_text(const Style& style, const std::vector<PlyElement>& elements);

/// See read_mesh() and write_mesh(). `outlines` are MergedPolygons::outlines.
ReadResult read_ply(const Source& source);
WriteResult write_ply(const Document& document, const Column* outlines = nullptr);

}  // namespace transformesh
