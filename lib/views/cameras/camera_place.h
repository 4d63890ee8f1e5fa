/// Finds the camera files of a folder.
#pragma once

#include <string>
#include <vector>

namespace transformesh {

/// Returns ".txt" or ".bin" if the folder has both files of COLMAP's model with this extension,
/// else "". Prefers text, unless `where` names a binary file.
std::string colmap_extension(const std::string& folder, const std::string& where);

/// Returns the camera files of a folder, including the views of MVE in it. Throws InputError if
/// their formats differ; returns nothing if there is none.
std::vector<std::string> camera_files_in(const std::string& folder);

/// Returns the folder itself if it holds cameras. Otherwise returns the subfolder in which COLMAP,
/// MVSNet or MVE would put them, such as `sparse/0`. Throws InputError if there are none, or if
/// COLMAP left several models.
std::string folder_with_cameras(const std::string& folder);

}  // namespace transformesh
