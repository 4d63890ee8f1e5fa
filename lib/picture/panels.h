/// Lays out the panels of a picture, with the mesh and the camera of each.
#pragma once

#include <span>
#include <vector>

#include "picture/picture.h"
#include "raster/camera.h"

namespace transformesh {

struct Panel {
  int x = 0;  ///< upper left corner, in pixels of the picture
  int y = 0;
  const Mesh* mesh = nullptr;
  Camera camera;  ///< camera of the panel, with its size
};

/// Lays out panels as described at draw_picture(), and throws as it does. Keeps references to the
/// meshes. Borders of panels are rounded to whole pixels. The lowest `strip` rows of pixels belong
/// to no panel.
std::vector<Panel> lay_out(std::span<const Mesh* const> meshes, const PictureOptions& options,
                           int strip);

}  // namespace transformesh
