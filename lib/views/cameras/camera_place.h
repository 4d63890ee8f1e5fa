/// Finds the camera files of a folder.
#pragma once

#include <string>
#include <vector>

namespace transformesh {

/// Returns ".txt" or ".bin" if the folder has both files cameras and images of COLMAP's model with
/// this extension, else "". If both are possible, returns ".txt", unless `where` is the path of a
/// binary file.
std::string colmap_extension(const std::string& folder, const std::string& where);

/// Returns the camera files of a folder, including the files meta.ini of MVE's views in its
/// subfolders. Throws InputError if their formats differ. Returns an empty list if there are none.
std::vector<std::string> camera_files_in(const std::string& folder);

/// Returns the folder itself if it contains camera files. Otherwise returns its subfolder in which
/// COLMAP, MVSNet or MVE has put them, such as `sparse/0`. Throws InputError if there are no camera
/// files, or if COLMAP left several models.
std::string folder_with_cameras(const std::string& folder);

}  // namespace transformesh
