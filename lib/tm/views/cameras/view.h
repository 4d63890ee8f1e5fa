/// One calibrated photograph.
#pragma once

#include <string>

#include "tm/views/cameras/pinhole_camera.h"
#include "tm/views/images/gray_image.h"

namespace transformesh {

struct View {
  std::string name;  ///< of the image file, without folder and extension
  PinholeCamera camera;
  GrayImage image;
  GrayImage silhouette;  ///< of the image's size, or empty where there is none
};

}  // namespace transformesh
