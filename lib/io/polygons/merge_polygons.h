/// Makes polygons of the triangles that a reader cut them into. A face column numbers the polygon
/// of each triangle, so that whatever selects or moves faces keeps polygons. Merged are all
/// triangles with one number: a polygon of which faces were dropped becomes what is left of it.
#pragma once

#include <span>

#include "transformesh/document.h"

namespace transformesh {

/// Face column with the number of the polygon that a triangle is part of, from 1 on; 0 if it is a
/// face by itself. Written to no file.
inline constexpr const char* polygon_column = "tm:polygon";

struct MergedPolygons {
  /// Each polygon is a face; its corners are in `outlines`. polygon_column is gone.
  Document document;
  Column outlines;           ///< lists: the vertices of each face in order
  std::size_t unmerged = 0;  ///< polygons left as triangles, as their outline is no single loop
};

/// O(n log n); deterministic. The document has polygon_column.
MergedPolygons merge_polygons(const Document& document);

/// Number of polygons, and of the triangles that they are cut into.
struct PolygonCount {
  std::size_t polygons = 0, triangles = 0;
};
PolygonCount count_polygons(const Columns& face_columns);

/// The corners of a face as a format writes them.
class FaceOutlines {
 public:
  /// Keeps references. `outlines` are MergedPolygons::outlines, or null for a mesh of triangles.
  FaceOutlines(const Mesh& mesh, const Column* outlines) : mesh_(mesh), lists_(outlines) {}
  std::size_t size(std::size_t face) const {
    return lists_ == nullptr ? 3 : lists_->list_offsets[face + 1] - lists_->list_offsets[face];
  }
  Index corner(std::size_t face, std::size_t i) const {
    return lists_ == nullptr ? mesh_.faces[face][i]
                             : static_cast<Index>(lists_->values[lists_->list_offsets[face] + i]);
  }

 private:
  const Mesh& mesh_;
  const Column* lists_;
};

}  // namespace transformesh
