/// Reads calibrated photographs: cameras, and the images and silhouettes that belong to them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "transformesh/views.h"
#include "views/cameras/camera_file.h"
#include "views/cameras/view.h"

namespace transformesh {

/// Value of ViewSources::reduction for previews: a quarter of the resolution, which is a sixteenth
/// of the pixels.
inline constexpr double preview_reduction = 4;

/// Reads views in the order of the cameras. A view is named after its image; without image, after
/// its silhouette; without both, after its camera.
///
/// If the camera file names images (Middlebury, COLMAP), images and silhouettes belong to the
/// camera of the same name. Otherwise they are paired by the rules in name_pairs.h. Names of
/// cameras may begin with folders, such as COLMAP's `left/0001.jpg`. Images are then searched in
/// these subfolders. Images and cameras without a partner may be left out (image_files.h).
///
/// Throws InputError, with the name of the file, if a file cannot be read or paired, or if a
/// silhouette is empty. Also throws it if the size of an image differs from that in the camera
/// file, or its aspect ratio from that of its silhouette. Images of different sizes with the same
/// intrinsics are an error, too. Files are decoded in parallel; result and error do not depend on
/// the number of threads.
std::vector<View> views_from(const ViewSources& sources);

/// A color photograph, which is decoded on request.
struct PictureView {
  std::string name;  ///< name of the image; see views_from()
  PinholeCamera camera;
  int width = 0;
  int height = 0;
  /// Decodes the undistorted photograph; throws InputError as views_from() does.
  std::function<Image()> picture;
};

/// Reads cameras and sizes of images; ignores silhouettes. Throws as views_from() does, except for
/// errors that only occur while decoding pixels.
std::vector<PictureView> picture_views_from(const ViewSources& sources);

/// Returns the cameras with the sizes and file names of their images, so that they can be written
/// in another format. `cameras` must have been read from `sources.cameras`. Throws as views_from()
/// does.
CameraList cameras_of_images(CameraList cameras, const ViewSources& sources);

}  // namespace transformesh
