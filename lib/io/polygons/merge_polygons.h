/// Merges triangles back into the polygons from which a file reader made them. A face column holds
/// the polygon number of each triangle, so that operations that select or move faces keep polygons.
/// All triangles with one number are merged. If some triangles of a polygon were dropped, the
/// polygon consists of the remaining triangles.
#pragma once

#include <span>

#include "transformesh/document.h"

namespace transformesh {

/// Face column with the number of the polygon to which a triangle belongs, from 1; 0 if the
/// triangle belongs to no polygon. The column is written to no file.
inline constexpr const char* polygon_column = "tm:polygon";

struct MergedPolygons {
  /// Each polygon is one face, whose corners are in `outlines`. The document has no polygon_column.
  Document document;
  Column outlines;  ///< list column: the vertices of each face in order
  /// Number of polygons that are written as triangles, because their outline is not a single loop.
  std::size_t unmerged = 0;
};

/// Merges the triangles of polygons. The document must have polygon_column. O(n log n);
/// deterministic.
MergedPolygons merge_polygons(const Document& document);

/// Number of polygons, and of the triangles into which they are cut.
struct PolygonCount {
  std::size_t polygons = 0, triangles = 0;
};
PolygonCount count_polygons(const Columns& face_columns);

/// The faces that a file writer writes: merged polygons, or the triangles of the mesh.
class FaceOutlines {
 public:
  /// Keeps references. `outlines` are MergedPolygons::outlines. Null: each face is a triangle of
  /// the mesh.
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
