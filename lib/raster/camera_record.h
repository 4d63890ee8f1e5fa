/// Cameras as camera files hold them: with the names, and perhaps the sizes, of their photographs.
#pragma once

#include <string>
#include <vector>

#include "raster/lens_distortion.h"
#include "transformesh/pinhole_camera.h"

namespace transformesh {

/// A camera and what its file says of the photograph.
struct CameraRecord {
  std::string name;   ///< the image's as written there; else the file's stem
  std::string place;  ///< `dino_par.txt line 3`, for messages
  PinholeCamera camera;
  int width = 0;  ///< of the image, or 0 where the file does not say
  int height = 0;
  LensDistortion distortion;  ///< of the photograph; the camera is the pinhole without it
  bool is_centered = false;   ///< the principal point is the center of an image of unknown size
  /// The intrinsics are in units of the larger side of an image of unknown size, with the principal
  /// point counted from its center.
  bool is_relative = false;

  /// Checks the image's size, and makes the intrinsics those of that size if that is still to be
  /// done. Throws InputError where the file says another size; `image` names it there.
  void set_size(int columns, int rows, const std::string& image);
};

struct CameraList {
  std::vector<CameraRecord> cameras;
  bool names_images = false;  ///< names are those of the images, which pair by them
};

}  // namespace transformesh
