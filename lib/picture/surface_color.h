/// The color of the surface itself, before any light falls on it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "picture/colormap.h"
#include "picture/linear_color.h"
#include "raster/rasterize.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct SurfaceColorOptions {
  /// Of every front side; without it the columns red, green and blue of the vertices, else of the
  /// faces (integers up to 255, floats up to 1), else a light blue-gray.
  std::optional<Color> front;
  /// Name of a face column, else of a vertex column: where it is not zero the surface is orange.
  /// None where empty.
  std::string highlight;
  /// Name of a column of numbers, of the faces, else of the vertices, that the surface is colored
  /// by instead: interpolated, and gray where not finite. None where empty.
  std::string by;
  ColorScale scale;
};

class SurfaceColor {
 public:
  /// Keeps a reference to the mesh. Throws UsageError where a column named is missing.
  SurfaceColor(const Mesh& mesh, const SurfaceColorOptions& options);

  /// Back sides are tinted towards dark red, so that surfaces inside out stand out.
  Color at(const FacePixel& pixel, bool is_front) const;

 private:
  const Mesh* mesh_;
  Color front_;
  std::vector<Color> vertex_colors_;  ///< empty where the vertices have none
  std::vector<Color> face_colors_;
  const Column* face_highlight_ = nullptr;
  const Column* vertex_highlight_ = nullptr;
  const Column* face_values_ = nullptr;
  const Column* vertex_values_ = nullptr;
  ColorScale scale_;
};

}  // namespace transformesh
