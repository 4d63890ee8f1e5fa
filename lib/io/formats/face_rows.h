/// Collects the faces that a reader finds in a file, where they may precede their vertices.
/// Triangulates polygons without folds (polygons/triangulate_polygon.h).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/polygons/planar_outline.h"
#include "transformesh/mesh.h"

namespace transformesh {

class FaceRows {
 public:
  void reserve(std::size_t faces) { triangles_.reserve(faces); }
  /// Appends triangles.
  void add(std::vector<Face> triangles) {
    rows_ += static_cast<std::uint32_t>(triangles.size());
    if (triangles_.empty()) return triangles_.swap(triangles);
    triangles_.insert(triangles_.end(), triangles.begin(), triangles.end());
  }
  /// Appends a triangle. The function is inline because readers call it in tight loops.
  void add(const Face& triangle) {
    triangles_.push_back(triangle);
    ++rows_;
  }
  /// Appends a polygon of any size. A polygon with fewer than three corners is dropped and counted.
  void add(std::span<const Index> corners);
  std::uint32_t rows() const { return rows_; }

  /// Sets whether move_into() stores the polygon of each triangle in polygon_column
  /// (merge_polygons.h), if there are polygons.
  void keep_polygons(bool keeps) { keeps_polygons_ = keeps; }

  /// Moves the faces into the mesh. The mesh must have all vertices, and its face columns must have
  /// one row for each added row. Afterwards face columns have one row for each triangle, with the
  /// texture coordinates of the triangle's corners. Vertices with a non-finite coordinate are
  /// dropped with the rows that use them. `notes` state how many faces were cut or dropped,
  /// numbered from `first_number`.
  void move_into(Mesh& mesh, const std::string& format, std::vector<std::string>& notes,
                 std::uint32_t first_number = 0);

 private:
  struct Polygon {
    std::uint32_t row;
    std::size_t first;  ///< index of the polygon's first corner in `corners_`
  };
  struct Cuts;

  std::span<const Index> corners_of(std::size_t polygon) const;
  Cuts cut_polygons(const Mesh& mesh) const;
  /// Calls add(triangle, origin) for each triangle in order. `origin` has the row of the polygon,
  /// its number of corners, and the corners from which the triangle is made.
  template <class Add>
  void for_each_triangle(const Cuts& cuts, const Add& add) const;
  void put_together(Mesh& mesh, const Cuts& cuts) const;
  void number_polygons(Mesh& mesh, const Cuts& cuts) const;
  void add_notes(const Cuts& cuts, std::size_t faces, const std::string& format,
                 std::vector<std::string>& notes, std::uint32_t first_number) const;

  std::vector<Face> triangles_;    ///< faces with three corners, in order
  std::vector<Polygon> polygons_;  ///< faces with any other number of corners, in order
  std::vector<Index> corners_;     ///< corners of all polygons, concatenated
  std::uint32_t rows_ = 0;
  bool keeps_polygons_ = false;
};

}  // namespace transformesh
