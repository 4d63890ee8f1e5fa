/// One picture of one or several meshes, side by side, each framed by itself.
#pragma once

#include <optional>
#include <span>
#include <utility>

#include "picture/shade.h"
#include "raster/camera.h"
#include "transformesh/control.h"

namespace transformesh {

/// What fills a panel: its own mesh; as much as the largest mesh needs, so that sizes compare; or
/// the box of all meshes, so that places compare too.
enum class Framing { each, scale, place };

struct PictureOptions {
  int width = 800;   ///< pixels of the whole picture, [1, 32768]
  int height = 600;  ///< at most 2^26 pixels in all
  Orbit orbit;       ///< orbit.up is also where the sky is
  Framing framing = Framing::each;
  /// Panels in a row; 0: all, but of several views one mesh in a row, or what makes the panels of a
  /// single mesh largest.
  int columns = 0;
  /// Panels of each mesh: from `orbit` on, the eye goes around it to its right, once in all.
  int views = 1;   ///< >= 1
  int frames = 1;  ///< >= 1: of a movie in which it goes around once, this is number `frame`
  int frame = 0;
  const Mesh* around = nullptr;  ///< frames this mesh in every panel instead: a movie keeps still
  ShadeOptions shade;  ///< of its scale, see `range`; the floor is set to where meshes end
  /// The numbers at the ends of the colors where shade.color.by is set; without it those of the
  /// finite values of all meshes.
  std::optional<std::pair<double, double>> range;
};

/// Panels go from left to right, then down. Where the eye goes around, the middle of the box is
/// what it looks at, and distances are the same for any number of views and frames. Throws
/// InputError for a mesh without faces, UsageError for a size or range out of range, with less than
/// a pixel for a panel, or a column to highlight or to color by that no mesh has; meshes without it
/// are drawn as if none was asked for. Where colors stand for numbers, the legend takes the bottom
/// of the picture. Deterministic for any number of threads.
Image draw_picture(std::span<const Mesh* const> meshes, const PictureOptions& options = {},
                   const Progress& progress = {});

}  // namespace transformesh
