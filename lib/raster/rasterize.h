/// Which face each pixel of a camera sees, at what depth, and where in the face.
/// Reference: Olano & Greer, "Triangle scan conversion using 2D homogeneous coordinates", Graphics
/// Hardware 1997: faces that reach behind the eye need no clipping.
///
/// A pixel sees what its center sees. Faces that share an edge leave no gap between them; of faces
/// at the same depth the lowest index is seen. Faces on edge to the eye, collapsed or behind it are
/// not seen, and of a closed surface the backs need not be drawn. Depths are floats, weights are
/// perspective-correct.
/// Cost: O(faces + pixels covered), parallel over rows; deterministic for any number of threads.
#pragma once

#include <array>
#include <vector>

#include "raster/camera.h"
#include "transformesh/image.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Pixels from the first to before the end; none where these are equal.
struct PixelBox {
  int first_column = 0, end_column = 0;
  int first_row = 0, end_row = 0;

  int columns() const { return end_column - first_column; }
  int rows() const { return end_row - first_row; }
};

struct FacePixel {
  Index face = no_index;
  float depth = 0;                ///< as the camera defines it
  std::array<float, 2> weight{};  ///< of the face's corners 0 and 1; that of corner 2 is the rest
};

using FaceBuffer = Raster<FacePixel>;

enum class Sides { both, outside };

FaceBuffer rasterize(const Mesh& mesh, const Camera& camera, Sides sides = Sides::both);

/// The same a band of rows at a time, for pictures that are not held as a whole. 24 bytes a vertex
/// and 4 a face that is seen.
class BandRasterizer {
 public:
  /// Keeps a reference to the mesh.
  BandRasterizer(const Mesh& mesh, const Camera& camera, int rows_per_band,
                 Sides sides = Sides::both);
  BandRasterizer(const BandRasterizer&) = delete;
  BandRasterizer& operator=(const BandRasterizer&) = delete;
  ~BandRasterizer() = default;

  std::size_t bands() const { return faces_.size(); }
  /// Around all pixels that see a face, and maybe some more.
  const PixelBox& box() const { return box_; }
  /// Draws rows_per_band rows, of which those below the picture stay empty, to `rows`, which is as
  /// wide as the picture and holds nothing. Safe to call from several threads at once.
  void draw(std::size_t band, FacePixel* rows) const;

 private:
  void sort_faces(const Camera& camera, Sides sides);

  const Mesh& mesh_;
  int width_, height_, rows_per_band_;
  std::vector<Vec3> projected_;  ///< vertices
  PixelBox box_;
  std::vector<std::vector<Index>> faces_;  ///< that touch each band, ascending
};

/// The linear functions of pixel (x, y, 1) that vanish on the image of the edge across from each
/// corner and are positive on the face's side of it. Their sum is `depth_numerator` / depth, each
/// one's share of the sum the corner's weight. All zero for a face that cannot be seen.
struct EdgeFunctions {
  std::array<Vec3, 3> edge{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  double depth_numerator = 0;
};
/// From the projections of the corners.
EdgeFunctions edge_functions(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace transformesh
