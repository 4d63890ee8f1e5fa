/// Calibrated photographs from files: cameras, images and silhouettes that belong together.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "views/cameras/camera_file.h"
#include "views/cameras/view.h"

namespace transformesh {

/// Each is a file, a folder or a pattern. Of a folder the files are taken that look like what is
/// wanted.
struct ViewSources {
  std::string cameras;      ///< see camera_file.h
  std::string images;       ///< empty: the views have none
  std::string silhouettes;  ///< empty: the views have none
  bool mirror = false;      ///< the cameras: PinholeCamera::mirrored
  /// Gets a line for each way in which masks were read otherwise than by what is not black.
  std::function<void(const std::string& note)> on_note = {};
};

/// The views in the order of the cameras, with the images' names, else the silhouettes', else the
/// cameras'.
///
/// Images and silhouettes are those of the camera that has their name where the camera file names
/// images (Middlebury, COLMAP); else see name_pairs.h. Throws InputError, naming the file, for what
/// the readers and the pairing refuse, for images whose size is not that of their silhouette or not
/// the one that the camera file says, for images of different sizes with the same intrinsics, and
/// for a silhouette without a pixel inside. Of a folder of images, the folders are searched that
/// the names of cameras begin with, as COLMAP's `left/0001.jpg`, where there are any. Files are
/// decoded on all allowed threads; the result and the error do not depend on their number.
std::vector<View> views_from(const ViewSources& sources);

/// Photographs in color, which are decoded one at a time when they are asked for.
struct PictureView {
  std::string name;  ///< as that of views_from
  PinholeCamera camera;
  int width = 0;
  int height = 0;
  std::function<Image()> picture;  ///< without distortion; throws InputError as views_from does
};

/// Silhouettes do not matter. Throws as views_from does, except for errors that only the pixels
/// show.
std::vector<PictureView> picture_views_from(const ViewSources& sources);

/// The same cameras with the sizes and file names of their images, for conversion. `where` names
/// the camera file in messages. Throws as views_from does.
CameraList cameras_of_images(CameraList cameras, const std::string& where,
                             const std::string& images);

}  // namespace transformesh
