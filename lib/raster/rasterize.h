/// Rasterizes a mesh: the visible face of each pixel, its depth, and the position in the face.
/// Reference: Olano & Greer, "Triangle scan conversion using 2D homogeneous coordinates", Graphics
/// Hardware 1997. This method needs no clipping of faces that reach behind the camera.
///
/// Visibility is decided at pixel centers. Faces with a common edge leave no gap between them. If
/// faces have the same depth, the one with the lowest index is visible. Faces that are observed
/// edge-on, degenerate or behind the camera are not visible. Back faces of closed surfaces need not
/// be drawn (Sides::outside). Depths are floats; the weights of corners are perspective-correct.
///
/// Cost: O(faces + covered pixels). Parallel over rows; deterministic for any number of threads.
#pragma once

#include <array>
#include <vector>

#include "raster/camera.h"
#include "transformesh/image.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// A rectangle of pixels. `end_column` and `end_row` are excluded; the rectangle is empty if an end
/// equals the first column or row.
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

/// Faces to draw: all faces, or only those of which the camera observes the outer side.
enum class Sides { both, outside };

/// Returns the visible face of each pixel of the whole image.
FaceBuffer rasterize(const Mesh& mesh, const Camera& camera, Sides sides = Sides::both);

/// Rasterizes one band of rows at a time, for pictures that are not stored as a whole. Takes 40
/// bytes per vertex and 4 per visible face.
class BandRasterizer {
 public:
  /// Keeps a reference to the mesh. Sorts faces into bands, unless `rows_per_band` is at least the
  /// height of the image.
  BandRasterizer(const Mesh& mesh, const Camera& camera, int rows_per_band,
                 Sides sides = Sides::both);
  BandRasterizer(const BandRasterizer&) = delete;
  BandRasterizer& operator=(const BandRasterizer&) = delete;
  ~BandRasterizer() = default;

  std::size_t bands() const { return faces_.size(); }
  /// Returns a box that contains all pixels in which a face is visible; the box may be slightly too
  /// large.
  const PixelBox& box() const { return box_; }
  /// Draws `rows_per_band` rows to `rows`, which must be empty and as wide as the picture. Rows
  /// below the picture stay empty. Thread-safe.
  void draw(std::size_t band, FacePixel* rows) const;
  /// Draws the rows of a band that are in the rectangle `part`, which must contain the columns of
  /// box(). `pixels` has the pixels of `part`, row by row; the pixels of the band must be empty.
  /// Thread-safe.
  void draw(std::size_t band, const PixelBox& part, FacePixel* pixels) const;

 private:
  /// Decides which faces are drawn. For Sides::outside, these are the faces for which the
  /// determinant of the three projected corners has the sign `sign`.
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
  std::vector<Vec3> projected_;  ///< vertices projected by Camera::project()
  /// Pixels of vertices; arbitrary for vertices behind the camera.
  std::vector<Eigen::Array2d> pixels_;
  PixelBox box_;
  /// For each band of rows, the faces that it shows, in ascending order; not stored if one band has
  /// all rows.
  std::vector<std::vector<Index>> faces_;
};

/// Three linear functions of a pixel (x, y, 1), one for each corner of a face. The function of a
/// corner is zero on the image of the opposite edge, and positive on the side of the face. The sum
/// of the functions is `depth_numerator` / depth. The weight of a corner is its function divided by
/// this sum. All functions are zero for a face that cannot be visible.
struct EdgeFunctions {
  std::array<Vec3, 3> edge{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  double depth_numerator = 0;
};
/// Returns the edge functions of a face from the projections of its corners by Camera::project().
EdgeFunctions edge_functions(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace transformesh
