/// One calibrated photograph.
#pragma once

#include <string>

#include "tm/views/gray_image.h"
#include "tm/views/pinhole_camera.h"

namespace transformesh {

struct View {
  std::string name;  ///< of the image file, without folder and extension
  PinholeCamera camera;
  GrayImage image;
  GrayImage silhouette;  ///< of the image's size, or empty where there is none
};

}  // namespace transformesh
