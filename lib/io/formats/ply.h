/// PLY: Greg Turk, The PLY Polygon File Format (Stanford, 1994), ASCII and both binary encodings.
#pragma once

#include <optional>

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

struct PlyProperty {
  std::string name;
  Scalar type = Scalar::float32;
  std::optional<Scalar> count_type;  ///< set for a list
};

struct PlyElement {
  std::string name;
  std::uint64_t rows = 0;  ///< as claimed
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  Style style;  ///< format, comments, names of elements
  std::vector<PlyElement> elements;
  std::size_t size = 0;               ///< where the data starts
  std::size_t unmarked_comments = 0;  ///< of the style's comments, those without their keyword
};

/// Reads the header alone. Throws InputError naming the line.
PlyHeader read_ply_header(const Source& source);

/// The text of a header with the format, comments and spelling of the style.
std::string ply_header_text(const Style& style, const std::vector<PlyElement>& elements);

/// See read_mesh and write_mesh.
ReadResult read_ply(const Source& source);
WriteResult write_ply(const Document& document);

}  // namespace transformesh
