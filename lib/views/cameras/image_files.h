/// Images and masks that belong to cameras.
#pragma once

#include <string>
#include <vector>

#include "raster/camera_record.h"
#include "transformesh/views.h"
#include "views/cameras/name_pairs.h"

namespace transformesh {

/// Returns the images at `where`, a file, folder or pattern. If names of cameras have folders,
/// looks for the images in these subfolders. `kind` is the noun for the files in messages. Throws
/// InputError if there is no image.
NamedFiles image_files(const std::string& kind, const std::string& where,
                       const CameraList& cameras);

/// Returns the names of the cameras, which were read from `where`.
NamedFiles names_of(const CameraList& cameras, const std::string& where);

struct PairedFiles {
  std::vector<std::string> paths;  ///< the file of each name that is kept
  std::vector<std::size_t> kept;   ///< indices of the names that are kept, ascending
};

/// Pairs names of cameras or images with files (name_pairs.h). Calls `sources.on_note` if names or
/// files are left out. Leaves out none if `sources.needs_all_images`.
/// - Names without a file are left out if all files have a name, names must agree, and at least
///   three names remain. Users delete photographs.
/// - Files without a name are left out if all names have a file, and if names must agree or `names`
///   are images.
///
/// Throws InputError as pair_by_name() does.
PairedFiles pair_files(NamedFiles names, NamedFiles files, bool names_must_agree,
                       const ViewSources& sources);

}  // namespace transformesh
