#include "views/cameras/camera_file.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "io/streams/file_list.h"
#include "transformesh/errors.h"
#include "views/cameras/camera_formats.h"
#include "views/cameras/camera_place.h"
#include "views/cameras/camera_readers.h"

namespace transformesh {
namespace {

void check_names(const CameraList& list) {
  std::set<std::string_view> names;
  for (const CameraRecord& record : list.cameras) {
    if (!names.insert(record.name).second) {
      throw InputError("a second camera is called " + in_quotes(record.name) + " (" + record.place +
                       ")");
    }
  }
}

CameraList parse(const Source& source, const std::string& stem) {
  if (source.bytes.empty()) source.fail("the input is empty: it contains no cameras");
  if (const auto format = camera_format(source.bytes)) return reader_of(*format).read(source, stem);
  source.fail("not a camera file, starting with " + in_quotes(source.bytes.substr(0, 16)) + ": " +
              known_camera_formats());
}

/// True if the path names one of COLMAP's two camera files, which are always read together.
bool is_colmap_section(const std::string& path) {
  const std::string name = std::filesystem::path(path).filename().string();
  return name == "cameras.txt" || name == "images.txt" || name == "cameras.bin" ||
         name == "images.bin";
}

CameraList read_colmap_folder(const std::filesystem::path& folder, const std::string& extension) {
  const std::string cameras = (folder / ("cameras" + extension)).string();
  const std::string images = (folder / ("images" + extension)).string();
  const std::string camera_bytes = file_bytes(cameras);
  const std::string image_bytes = file_bytes(images);
  const Source camera_source{camera_bytes, cameras};
  const Source image_source{image_bytes, images};
  return extension == ".bin" ? read_colmap_binary(camera_source, image_source)
                             : read_colmap(camera_source, image_source);
}

void append(CameraList& list, CameraList further) {
  list.names_images = list.names_images || further.names_images;
  std::move(further.cameras.begin(), further.cameras.end(), std::back_inserter(list.cameras));
}

CameraList read_file(const std::string& path) {
  const std::string bytes = file_bytes(path);
  const Source source{bytes, path};
  return parse(source, stem_of(path));
}

}  // namespace

CameraList parse_cameras(std::string_view bytes, const std::string& name, const std::string& stem) {
  const Source source{bytes, name};
  CameraList list = parse(source, stem.empty() ? stem_of(name) : stem);
  if (list.cameras.empty()) source.fail("no view has a pose");
  check_names(list);
  return list;
}

CameraList cameras_from(const std::string& where) {
  const std::string folder = is_folder(where) ? folder_with_cameras(where)
                                              : std::filesystem::path(where).parent_path().string();
  CameraList list;
  const bool may_be_colmap = is_folder(where) || is_colmap_section(where);
  const std::string extension = may_be_colmap ? colmap_extension(folder, where) : std::string();
  if (!extension.empty()) {
    list = read_colmap_folder(folder, extension);
  } else {
    const auto files = is_folder(where) ? camera_files_in(folder) : files_at(where);
    for (const std::string& path : files) append(list, read_file(path));
  }
  if (list.cameras.empty()) throw InputError(where + ": no view has a pose");
  check_names(list);
  return list;
}

}  // namespace transformesh
