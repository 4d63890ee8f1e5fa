/// Random access to the rows of a binary PLY file, for meshes larger than memory. All rows of an
/// element have the same size, so the offset of a row follows from its index.
#pragma once

#include "io/formats/ply.h"
#include "io/streams/mapped_file.h"
#include "mesh/triangle.h"

namespace transformesh {

class PlyRows {
 public:
  /// Requires a regular file of binary PLY that has only vertices and triangles, no lists except
  /// the corners, and the size that the header implies. Throws InputError otherwise.
  explicit PlyRows(const std::string& path);

  const PlyHeader& header() const { return header_; }
  const PlyElement& vertex_element() const { return header_.elements[vertices_.element]; }
  const PlyElement& face_element() const { return header_.elements[faces_.element]; }
  std::size_t vertex_count() const { return vertices_.count; }
  std::size_t face_count() const { return faces_.count; }
  /// Returns the type of the coordinates.
  Scalar coordinate() const;

  /// Returns the position of a vertex. Throws InputError if a coordinate is not finite.
  Vec3 position(std::size_t vertex) const;
  /// Returns a face. Throws InputError if it is not a triangle or has an index out of range. From
  /// time to time, releases the memory of pages of the file that were read.
  Face face(std::size_t face) const;
  Triangle triangle(const Face& face) const;

  /// Append the bytes of a row to `bytes`: append_vertex() the row of a vertex, append_face() the
  /// row of a face with other corners, of type `index_type`.
  void append_vertex(std::size_t vertex, std::string& bytes) const;
  void append_face(std::size_t face, const Face& corners, Scalar index_type,
                   std::string& bytes) const;
  /// Returns the header of a file with these numbers of rows and this type of corner indices.
  std::string header_text(const std::vector<std::string>& comments, std::size_t vertices,
                          std::size_t faces, Scalar index_type) const;
  Scalar index_type() const { return face_element().properties[list_].type; }

 private:
  struct Table {
    std::size_t element = 0;  ///< index of the element in the header
    std::size_t count = 0;
    std::size_t stride = 0;
    const char* first = nullptr;
    const char* row(std::size_t i) const { return first + i * stride; }
  };

  Table& table_of(const std::string& name);
  void place_tables();
  void find_coordinates();
  void find_corners();

  MappedFile file_;
  Source source_;
  PlyHeader header_;
  Table vertices_, faces_;
  std::array<std::size_t, 3> axis_offset_{};
  std::array<Scalar, 3> axis_type_{};
  std::size_t list_ = 0;         ///< index of the property that holds the corners
  std::size_t list_offset_ = 0;  ///< offset of the corner count in a row; bytes
  bool is_swapped_ = false;
  mutable std::size_t reads_ = 0;
};

}  // namespace transformesh
