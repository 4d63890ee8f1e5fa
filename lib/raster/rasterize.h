/// Rasterizes a mesh: the visible face of each pixel, its depth, and the position in the face.
/// Reference: Olano & Greer, "Triangle scan conversion using 2D homogeneous coordinates", Graphics
/// Hardware 1997. Faces that reach behind the camera thus need no clipping.
///
/// Visibility is decided at pixel centers. Faces with a common edge leave no gap between them. If
/// faces have the same depth, the one with the lowest index is visible. Faces that are observed
/// edge-on, degenerate or behind the camera are not visible. For closed surfaces, back faces need
/// not be drawn. Depths are floats; weights are perspective-correct.
///
/// Cost: O(faces + covered pixels). Parallel over rows; deterministic for any number of threads.
#pragma once

#include <array>
#include <vector>

#include "raster/camera.h"
#include "transformesh/image.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// A rectangle of pixels. Ends are excluded; the rectangle is empty if an end equals its beginning.
struct PixelBox {
  int first_column = 0, end_column = 0;
  int first_row = 0, end_row = 0;

  int columns() const { return end_column - first_column; }
  int rows() const { return end_row - first_row; }
};

struct FacePixel {
  Index face = no_index;
  float depth = 0;  ///< depth as defined by Camera
  /// Weights of the face's corners 0 and 1; the weights of all three corners sum to 1.
  std::array<float, 2> weight{};
};

using FaceBuffer = Raster<FacePixel>;

enum class Sides { both, outside };

FaceBuffer rasterize(const Mesh& mesh, const Camera& camera, Sides sides = Sides::both);

/// Rasterizes one band of rows at a time, for pictures that are not stored as a whole. Takes 40
/// bytes per vertex and 4 per visible face.
class BandRasterizer {
 public:
  /// Keeps a reference to the mesh. A single band of all rows takes no time for sorting faces.
  BandRasterizer(const Mesh& mesh, const Camera& camera, int rows_per_band,
                 Sides sides = Sides::both);
  BandRasterizer(const BandRasterizer&) = delete;
  BandRasterizer& operator=(const BandRasterizer&) = delete;
  ~BandRasterizer() = default;

  std::size_t bands() const { return faces_.size(); }
  /// Returns a box around all pixels that show a face; the box may be slightly too large.
  const PixelBox& box() const { return box_; }
  /// Draws `rows_per_band` rows to `rows`, which must be empty and as wide as the picture. Rows
  /// below the picture stay empty. Thread-safe.
  void draw(std::size_t band, FacePixel* rows) const;
  /// Draws the rows of a band that are in `part`, which must contain the columns of box(). `pixels`
  /// has the pixels of `part`, row by row; those of the band must be empty. Thread-safe.
  void draw(std::size_t band, const PixelBox& part, FacePixel* pixels) const;

 private:
  /// Decides which faces are drawn. If only outsides are drawn, these are the faces whose projected
  /// corners have a determinant of `sign`.
  struct Drawn {
    bool is_both = true;
    double sign = 0;

    bool operator()(const std::array<Vec3, 3>& corners) const;
  };

  bool is_whole() const { return rows_per_band_ >= height_; }
  std::array<Vec3, 3> corners_of(const Face& face) const;
  void sort_faces();
  void bound_vertices();
  void draw_face(Index face, int first, int last, const PixelBox& part, FacePixel* pixels) const;

  const Mesh& mesh_;
  int width_, height_, rows_per_band_;
  Drawn is_drawn_;
  std::vector<Vec3> projected_;         ///< projected vertices
  std::vector<Eigen::Array2d> pixels_;  ///< their pixels; arbitrary behind the camera
  PixelBox box_;
  /// Faces that touch each band, ascending; not stored if there is one band of all rows.
  std::vector<std::vector<Index>> faces_;
};

/// Linear functions of pixel (x, y, 1). Each vanishes on the image of the edge opposite to a
/// corner, and is positive on the face's side of the edge. The sum of the functions is
/// `depth_numerator` / depth; the fraction of each one in the sum is the weight of the corner. All
/// are zero for a face that cannot be visible.
struct EdgeFunctions {
  std::array<Vec3, 3> edge{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  double depth_numerator = 0;
};
/// Returns the functions of a face from the projections of its corners.
EdgeFunctions edge_functions(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace transformesh
