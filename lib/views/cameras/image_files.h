/// Finds the image and mask files that belong to cameras.
#pragma once

#include <string>
#include <vector>

#include "raster/camera_record.h"
#include "transformesh/views.h"
#include "views/cameras/name_pairs.h"

namespace transformesh {

/// Returns the image files at `where`, which is a file, a folder or a pattern. If names of cameras
/// contain folders, such as `left/0001.jpg`, searches these subfolders. `kind` is the noun for such
/// a file in messages. Throws InputError if there is no image.
NamedFiles image_files(const std::string& kind, const std::string& where,
                       const CameraList& cameras);

/// Returns the names of the cameras as a list that can be paired with files. `where` is the camera
/// file, for messages.
NamedFiles names_of(const CameraList& cameras, const std::string& where);

struct PairedFiles {
  std::vector<std::string> paths;  ///< path of the file with which each kept name is paired
  std::vector<std::size_t> kept;  ///< indices of the names that have a file and are kept, ascending
};

/// Pairs names of cameras or images with files (name_pairs.h). Calls `sources.on_note` if names or
/// files are left out. None are left out if `sources.needs_all_images` is true. Otherwise:
/// - Names without a file are left out if all files have a name, `names_must_agree` is true, and at
///   least three names remain. The reason is that users delete photographs.
/// - Files without a name are left out if all names have a file, and if `names_must_agree` is true
///   or `names` are names of images.
///
/// Throws InputError as pair_by_name() does.
PairedFiles pair_files(NamedFiles names, NamedFiles files, bool names_must_agree,
                       const ViewSources& sources);

}  // namespace transformesh
