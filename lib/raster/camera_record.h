/// Cameras with the data that camera files contain in addition: names and sometimes sizes of their
/// photographs.
#pragma once

#include <string>
#include <vector>

#include "raster/lens_distortion.h"
#include "transformesh/pinhole_camera.h"

namespace transformesh {

/// The unit of intrinsics in a camera file: a pixel, the width of the image, or its larger side.
enum class IntrinsicsUnit { pixel, width, larger_side };

/// A camera and the data of its photograph in a camera file.
struct CameraRecord {
  /// Name of the image as written in the camera file; if it contains none, the name of the camera
  /// file without extension.
  std::string name;
  std::string place;  ///< camera file and line for messages, such as `dino_par.txt line 3`
  PinholeCamera camera;
  int width = 0;  ///< width of the image; 0 if the camera file does not contain it
  int height = 0;
  /// Lens distortion of the photograph; `camera` is the pinhole camera of the photograph without
  /// distortion.
  LensDistortion distortion;
  /// True if the principal point is relative to the center of the image, because the size of the
  /// image is unknown.
  bool is_centered = false;
  /// Unit of the intrinsics of `camera`. If it is not the pixel, the size of the image is still
  /// unknown.
  IntrinsicsUnit unit = IntrinsicsUnit::pixel;

  /// Sets the size of the image, and converts intrinsics to pixels. Throws InputError if the camera
  /// file contains another size; the message then names `image`.
  void set_size(int columns, int rows, const std::string& image);
};

struct CameraList {
  std::vector<CameraRecord> cameras;
  bool names_images = false;  ///< true if the names of cameras are names of images
};

}  // namespace transformesh
