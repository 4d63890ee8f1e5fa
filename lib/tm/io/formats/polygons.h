/// Gathers the polygons of a file as triangles: fans from the first corner. A polygon that visits a
/// corner again is cut into loops there, whose oriented edges are its own but for spikes that run
/// forth and back.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

class PolygonFans {
 public:
  void reserve(std::size_t faces) { faces_.reserve(faces); }
  /// Appends a triangle; inline, for the tight loops.
  void add(const Face& triangle) {
    if (remembers_sources_) source_.push_back(rows_);
    faces_.push_back(triangle);
    ++rows_;
  }
  /// Appends a polygon of any size; with fewer than three corners it only counts as dropped.
  void add(std::span<const Index> corners);
  std::uint32_t rows() const { return rows_; }

  /// Moves the faces into the mesh, whose face columns have one row for each polygon and get one
  /// for each triangle (of texture coordinates, those of its corners), and says in notes what was
  /// cut or dropped.
  void move_into(Mesh& mesh, const std::string& format, std::vector<std::string>& notes);

 private:
  void remember_sources();
  void add_fan(std::span<const Index> corners);
  void add_loops(std::span<const Index> corners);

  std::vector<Face> faces_;
  bool remembers_sources_ = false;     ///< from the first polygon on that is no triangle
  std::vector<std::uint32_t> source_;  ///< then, the polygon that each face comes from
  std::uint32_t rows_ = 0;
  std::size_t polygons_ = 0;
  std::size_t polygon_faces_ = 0;
  std::size_t repeating_ = 0;
  std::size_t dropped_ = 0;
};

}  // namespace transformesh
