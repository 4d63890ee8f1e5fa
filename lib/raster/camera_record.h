/// Cameras as in camera files: with names and possibly sizes of their photographs.
#pragma once

#include <string>
#include <vector>

#include "raster/lens_distortion.h"
#include "transformesh/pinhole_camera.h"

namespace transformesh {

/// The unit of intrinsics in a camera file: pixels, or a side of the image.
enum class IntrinsicsUnit { pixel, width, larger_side };

/// A camera and the data of its photograph in a camera file.
struct CameraRecord {
  std::string name;   ///< name of the image as written in the file; else the stem of the file
  std::string place;  ///< file and line for messages, such as `dino_par.txt line 3`
  PinholeCamera camera;
  int width = 0;  ///< size of the image; 0 if the file does not contain it
  int height = 0;
  /// Distortion of the photograph; `camera` is the pinhole camera without it.
  LensDistortion distortion;
  /// If true, the principal point is relative to the center of the image, whose size is unknown.
  bool is_centered = false;
  /// Units other than pixels mean that the size of the image is unknown.
  IntrinsicsUnit unit = IntrinsicsUnit::pixel;

  /// Sets the size of the image, and converts intrinsics to pixels. Throws InputError if the file
  /// contains another size; `image` is the name of the image in the message.
  void set_size(int columns, int rows, const std::string& image);
};

struct CameraList {
  std::vector<CameraRecord> cameras;
  bool names_images = false;  ///< if true, cameras have the names of their images
};

}  // namespace transformesh
