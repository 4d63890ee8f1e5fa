/// The panels of a picture: which mesh is in each, where, and seen by what camera.
#pragma once

#include <span>
#include <vector>

#include "picture/picture.h"
#include "raster/camera.h"

namespace transformesh {

struct Panel {
  int x = 0;  ///< pixels of the picture, from its upper left corner
  int y = 0;
  const Mesh* mesh = nullptr;
  Camera camera;  ///< as large as the panel
};

/// As draw_picture() says, and with its errors. Keeps references to the meshes. Their borders are
/// the nearest whole pixels; the lowest rows of pixels, as many as `strip` says, are in none.
std::vector<Panel> lay_out(std::span<const Mesh* const> meshes, const PictureOptions& options,
                           int strip);

}  // namespace transformesh
