/// Color of the surface before lighting.
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
  /// Color of all front sides. Default: the columns red, green and blue of the vertices, else of
  /// the faces, else a light blue-gray. Columns of integers range up to 255, of uint16 up to 65535,
  /// of floats up to 1.
  std::optional<Color> front;
  /// Name of a face column, else of a vertex column. The surface is orange where the column is not
  /// zero. Ignored if empty.
  std::string highlight;
  /// Name of a number column of the faces, else of the vertices. If given, the color scale maps its
  /// values to the colors of the surface. Values are interpolated; values that are not finite are
  /// gray. Ignored if empty.
  std::string by;
  ColorScale scale;
};

class SurfaceColor {
 public:
  /// Keeps a reference to the mesh. Throws UsageError if a named column is missing.
  SurfaceColor(const Mesh& mesh, const SurfaceColorOptions& options);

  /// Back sides are tinted dark red, so that inverted surfaces are noticed.
  Color at(const FacePixel& pixel, bool is_front) const;

 private:
  const Mesh* mesh_;
  Color front_;
  std::vector<Color> vertex_colors_;  ///< empty if the vertices have no colors
  std::vector<Color> face_colors_;
  const Column* face_highlight_ = nullptr;
  const Column* vertex_highlight_ = nullptr;
  const Column* face_values_ = nullptr;
  const Column* vertex_values_ = nullptr;
  ColorScale scale_;
};

}  // namespace transformesh
