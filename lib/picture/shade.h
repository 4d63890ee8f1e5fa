/// Shades the faces that a camera observes.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "picture/linear_color.h"
#include "picture/surface_color.h"
#include "raster/camera.h"
#include "raster/rasterize.h"
#include "transformesh/image.h"

namespace transformesh {

struct ShadeOptions {
  SurfaceColorOptions color;
  Background background;
  double crease_angle_deg = 40;  ///< edges that bend more are creases; [0, 180]; 0: flat shading
  /// Name of a vertex column written by set_openness(), which darkens front sides. Ignored if empty
  /// or if the mesh has no such column.
  std::string openness;
  /// The key light is a disc of 8 degrees, and faces cast soft shadows on each other. If `floor` is
  /// given, they also cast shadows on a floor at this height along `upright`. Only the shadow on
  /// the floor is drawn.
  bool soft_shadow = false;
  std::optional<double> floor;
  bool draw_edges = false;                      ///< lines along the edges of faces, one pixel wide
  std::vector<std::pair<Vec3, Vec3>> segments;  ///< drawn if no surface occludes them
  Vec3 upright = Vec3::UnitY();                 ///< unit vector towards the sky
  int samples = 3;  ///< samples per pixel along each axis, against aliasing; [1, 8]
};

/// Returns a picture of camera.width x camera.height pixels. A mesh without faces yields the
/// background. Throws UsageError if the column to highlight is missing. Time: O(faces + pixels *
/// samples^2). Memory: 4 bytes per pixel, 200 per face, and 55 MB for a soft shadow. Each thread
/// takes 2 MB for samples, or more if one row needs more. Parallel; the result does not depend on
/// the number of threads.
Image shade(const Mesh& mesh, const Camera& camera, const ShadeOptions& options = {});

/// Draws into a part of `image`, whose upper left corner is at (left, above). The image must be
/// large enough.
void shade(const Mesh& mesh, const Camera& camera, const ShadeOptions& options, int left, int above,
           Image& image);

}  // namespace transformesh
