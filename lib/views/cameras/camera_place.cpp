#include "views/cameras/camera_place.h"

#include <algorithm>
#include <filesystem>

#include "io/streams/file_list.h"
#include "transformesh/errors.h"
#include "views/cameras/camera_format.h"
#include "views/cameras/camera_readers.h"

namespace transformesh {
namespace {

namespace fs = std::filesystem;

bool has_colmap_files(const fs::path& folder, const std::string& extension) {
  return is_file((folder / ("cameras" + extension)).string()) &&
         is_file((folder / ("images" + extension)).string());
}

std::vector<std::string> files_in(const std::string& folder) {
  const auto is_regular = [](const fs::directory_entry& entry) { return entry.is_regular_file(); };
  const bool has_file =
      std::any_of(fs::directory_iterator(folder), fs::directory_iterator(), is_regular);
  std::vector<std::string> files;
  if (has_file) files = files_at(folder);
  for (const std::string& view : folders_at(folder))
    if (view.ends_with(".mve") && is_file(view + "/meta.ini")) files.push_back(view + "/meta.ini");
  return files;
}

bool has_cameras(const std::string& folder) {
  return is_folder(folder) &&
         (!colmap_extension(folder, folder).empty() || !camera_files_in(folder).empty());
}

/// Throws InputError if `folder` is COLMAP's model `0` and its parent folder also contains a model
/// `1`.
void check_single_model(const fs::path& folder) {
  const fs::path second = folder.parent_path() / "1";
  if (folder.filename() == "0" && is_folder(second.string()))
    throw InputError(folder.parent_path().string() +
                     ": there are several models, 0 and 1: name one of them");
}

}  // namespace

std::string colmap_extension(const std::string& folder, const std::string& where) {
  const bool is_binary_named = where.ends_with(".bin");
  if (!is_binary_named && has_colmap_files(folder, ".txt")) return ".txt";
  const bool is_text_named = where.ends_with(".txt");
  return !is_text_named && has_colmap_files(folder, ".bin") ? ".bin" : "";
}

std::vector<std::string> camera_files_in(const std::string& folder) {
  std::vector<std::string> files;
  std::optional<CameraFormat> format;
  for (const std::string& path : files_in(folder)) {
    const auto found = camera_format(file_bytes(path, 4096));
    if (!found) continue;
    if (format && *format != *found) {
      throw InputError(std::string(folder)
                           .append(": this folder has camera files of different formats, ")
                           .append(files.back())
                           .append(" and ")
                           .append(path)
                           .append(": name one, or a quoted pattern"));
    }
    format = found;
    files.push_back(path);
  }
  return files;
}

std::string folder_with_cameras(const std::string& folder) {
  if (has_cameras(folder)) return folder;
  for (const char* place :
       {"0", "sparse", "sparse/0", "dense/0/sparse", "dense/sparse", "cams", "views"}) {
    const fs::path subfolder = fs::path(folder) / place;
    if (!has_cameras(subfolder.string())) continue;
    check_single_model(subfolder);
    return subfolder.string();
  }
  throw InputError(folder + ": there is no camera file in this folder: " + known_camera_formats());
}

}  // namespace transformesh
