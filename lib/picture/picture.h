/// Draws one or several meshes side by side in one picture.
#pragma once

#include <optional>
#include <span>
#include <utility>

#include "picture/shade.h"
#include "raster/camera.h"
#include "transformesh/control.h"

namespace transformesh {

/// `each` fits each panel to its own mesh. `scale` gives all panels the scale of the largest mesh,
/// so that sizes are comparable. `place` fits all panels to the bounding box of all meshes, so that
/// positions are comparable.
enum class Framing { each, scale, place };

struct PictureOptions {
  int width = 800;   ///< width of the whole picture in pixels, [1, 32768]
  int height = 600;  ///< at most 2^26 pixels in total
  Orbit orbit;       ///< `orbit.up` is also the upward direction of lights and floor
  Framing framing = Framing::each;
  /// Number of panels in a row. If it is 0 and `views` is 1, all panels form one row. If it is 0
  /// and there are several views, each mesh has its own row. The views of a single mesh are laid
  /// out such that panels are as large as possible.
  int columns = 0;
  /// Number of panels of each mesh. From panel to panel, the camera moves to the right around the
  /// mesh. The panels together show one full turn that starts at `orbit`.
  int views = 1;   ///< >= 1
  int frames = 1;  ///< number of pictures in a movie in which the camera moves around once, >= 1
  int frame = 0;
  /// Draws only this mesh. With Framing::place, camera and colors are chosen for all meshes. The
  /// separate pictures of all meshes can then be the frames of a movie.
  std::optional<std::size_t> only{};
  /// If given, cameras are fitted to this mesh instead of the drawn meshes. In a movie, the camera
  /// then does not depend on the frame.
  const Mesh* around = nullptr;
  ShadeOptions shade;  ///< `range` sets its color scale; the floor is placed under the meshes
  /// Values at the ends of the color scale if shade.color.by is set. Default: the range of the
  /// finite values of all meshes.
  std::optional<std::pair<double, double>> range;
};

/// Returns the corners of the bounding box of all meshes, as a mesh for PictureOptions::around.
/// Fitting cameras to eight corners is faster than to all vertices for each picture.
Mesh corners_around(std::span<const Mesh* const> meshes);

/// Draws the panels from left to right, then down. A camera that moves around looks at the center
/// of the bounding box. Its distance does not depend on the number of views and frames. If colors
/// represent numbers, a legend covers the bottom of the picture. A mesh without the column to
/// highlight or to color by is drawn normally.
///
/// Throws InputError if a mesh has no faces. Throws UsageError if size or range are invalid, or if
/// a panel would have less than a pixel. Also throws it if no mesh has the column to highlight or
/// to color by. Deterministic for any number of threads.
Image draw_picture(std::span<const Mesh* const> meshes, const PictureOptions& options = {},
                   const Progress& progress = {});

}  // namespace transformesh
