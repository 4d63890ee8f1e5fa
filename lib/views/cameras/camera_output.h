/// Writes camera files.
#pragma once

#include <string>
#include <vector>

#include "raster/camera_record.h"
#include "views/cameras/camera_format.h"

namespace transformesh {

/// A camera file to be written.
struct CameraText {
  std::string name;
  std::string text;
};

/// Returns the content of a single file, from which the same cameras can be read. Throws InputError
/// if the format cannot store the cameras:
/// - Only Middlebury, matrices, COLMAP, OpenCV, transforms.json, Meshroom and OpenMVS are written.
/// - OpenCV's files contain one camera, and COLMAP's binary model has several files.
/// - COLMAP, transforms.json, Meshroom and OpenMVS need the sizes of the images.
/// - Only Middlebury and matrices can store skew.
/// - Middlebury, matrices and OpenMVS cannot store distortion.
/// - Only COLMAP and OpenCV can store the distortion coefficients k4 to k6.
/// - Middlebury needs names without blanks; no format stores empty names.
///
/// Also throws if intrinsics of a camera depend on the size of its image, and the size is not
/// known.
std::string write_cameras(const CameraList& list, CameraFormat format);

/// Returns the files that other programs expect in a folder of this format. These are COLMAP's
/// three files, one file such as `cameras_par.txt` or `transforms.json`, or for each camera a
/// matrix `NAME.txt` or OpenCV's `NAME.yml`. Throws as write_cameras() does, except that formats
/// with several files are allowed.
std::vector<CameraText> write_camera_files(const CameraList& list, CameraFormat format);

}  // namespace transformesh
