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

/// Returns one text that is read back as the same cameras. Throws InputError if the format cannot
/// store the cameras:
/// - Only Middlebury, matrices, COLMAP, OpenCV, transforms.json, Meshroom and OpenMVS are written.
/// - OpenCV's files contain one camera, and COLMAP's binary model has several files.
/// - COLMAP, transforms.json, Meshroom and OpenMVS need the sizes of the images.
/// - Only Middlebury and matrices have skew.
/// - Middlebury, matrices and OpenMVS have no distortion; only COLMAP and OpenCV have k4 to k6.
/// - Middlebury needs names without blanks; all formats need names that are not empty.
///
/// Also throws if a camera depends on the size of an image that is not known.
std::string write_cameras(const CameraList& list, CameraFormat format);

/// Returns the files that programs of the format expect in a folder. These are COLMAP's three
/// files, one file such as `cameras_par.txt` or `transforms.json`, or for each camera a matrix
/// `NAME.txt` or OpenCV's `NAME.yml`. Throws as write_cameras() does, except that several files are
/// possible.
std::vector<CameraText> write_camera_files(const CameraList& list, CameraFormat format);

}  // namespace transformesh
