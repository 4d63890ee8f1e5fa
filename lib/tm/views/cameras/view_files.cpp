#include "tm/views/cameras/view_files.h"

#include <algorithm>
#include <exception>
#include <filesystem>

#include "tm/support/error.h"
#include "tm/support/parallel.h"
#include "tm/views/cameras/file_list.h"
#include "tm/views/cameras/name_pairs.h"
#include "tm/views/images/image_file.h"

namespace transformesh {
namespace {

NamedFiles image_files(const std::string& kind, const std::string& where) {
  NamedFiles files{kind, where, files_at(where), {}};
  if (!is_folder(where)) return files;
  std::erase_if(files.paths,
                [](const std::string& path) { return !is_image(file_bytes(path, 16)); });
  if (files.paths.empty()) throw InputError(where + ": there is no image in this folder");
  return files;
}

NamedFiles names_of(const CameraList& cameras, const std::string& where) {
  NamedFiles files{"camera", where, {}, {}};
  for (const CameraRecord& record : cameras.cameras) {
    files.paths.push_back(record.name);
    files.places.push_back(record.place);
  }
  return files;
}

/// The paths of `files` in the order of their partners among `names`.
std::vector<std::string> ordered(const NamedFiles& names, const NamedFiles& files,
                                 bool names_must_agree) {
  std::vector<std::string> paths;
  for (const std::size_t i : pair_by_name(names, files, names_must_agree)) {
    paths.push_back(files.paths[i]);
  }
  return paths;
}

using Decode = GrayImage (*)(std::string_view bytes, const std::string& name);

/// Decodes all files into a member of their views. Where several files are bad, the first of them
/// is named, for any number of threads.
void decode_all(const std::vector<std::string>& paths, Decode decode, GrayImage View::*member,
                std::vector<View>& views) {
  std::vector<std::exception_ptr> failures(paths.size());
  parallel_for(paths.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      try {
        views[i].*member = decode(file_bytes(paths[i]), paths[i]);
      } catch (const InputError&) {
        failures[i] = std::current_exception();
      }
    }
  });
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

std::string size_text(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

std::string size_text(const GrayImage& image) { return size_text(image.width, image.height); }

bool is_size_equal(const GrayImage& first, const GrayImage& second) {
  return first.width == second.width && first.height == second.height;
}

void check_silhouette(const View& view, const std::string& path) {
  if (!view.image.empty() && !is_size_equal(view.image, view.silhouette)) {
    throw InputError(path + ": the silhouette has " + size_text(view.silhouette) +
                     ", but its image has " + size_text(view.image));
  }
  for (const float level : view.silhouette.pixels) {
    if (level != 0) return;
  }
  throw InputError(path + ": the silhouette is empty: no pixel is inside");
}

const GrayImage& sized_image(const View& view) {
  return view.image.empty() ? view.silhouette : view.image;
}

struct SizedCamera {
  Eigen::Matrix3d intrinsics;
  int width = 0;
  int height = 0;
  std::string path;  ///< of the image
};

/// Images of different sizes cannot have the same intrinsics.
void check_sizes(const std::vector<SizedCamera>& cameras) {
  for (const SizedCamera& camera : cameras) {
    const auto same_lens = std::find_if(
        cameras.begin(), cameras.end(),
        [&](const SizedCamera& other) { return other.intrinsics == camera.intrinsics; });
    if (camera.width == same_lens->width && camera.height == same_lens->height) continue;
    throw InputError(camera.path + ": the image has " + size_text(camera.width, camera.height) +
                     ", but " + same_lens->path + ", of the same intrinsics, has " +
                     size_text(same_lens->width, same_lens->height));
  }
}

}  // namespace

std::vector<View> views_from(const ViewSources& sources) {
  CameraList list = cameras_from(sources.cameras);
  const NamedFiles names = names_of(list, sources.cameras);
  std::vector<std::string> images;
  std::vector<std::string> silhouettes;
  std::vector<View> views(list.cameras.size());

  // Silhouettes pair with the images, if there are any, rather than with the cameras: files of
  // matrices name no images, and then pair by their order.
  NamedFiles leaders = names;
  if (!sources.images.empty()) {
    images = ordered(names, image_files("image", sources.images), list.names_images);
    decode_all(images, decode_photograph, &View::image, views);
    leaders = {"image", sources.images, images, {}};
  }
  if (!sources.silhouettes.empty()) {
    const bool names_must_agree = images.empty() && list.names_images;
    silhouettes =
        ordered(leaders, image_files("silhouette", sources.silhouettes), names_must_agree);
    decode_all(silhouettes, decode_silhouette, &View::silhouette, views);
    if (images.empty()) leaders.paths = silhouettes;
  }

  std::vector<SizedCamera> sized;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const GrayImage& image = sized_image(views[i]);
    if (!image.empty()) list.cameras[i].set_size(image.width, image.height, leaders.paths[i]);
    views[i].camera = list.cameras[i].camera;
    sized.push_back({views[i].camera.intrinsics, image.width, image.height, leaders.paths[i]});
    views[i].name = stem_of(leaders.paths[i]);
    if (!silhouettes.empty()) check_silhouette(views[i], silhouettes[i]);
  }
  check_sizes(sized);
  return views;
}

CameraList cameras_of_images(CameraList cameras, const std::string& where,
                             const std::string& images) {
  const auto paths =
      ordered(names_of(cameras, where), image_files("image", images), cameras.names_images);
  std::vector<SizedCamera> sized;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const GrayImage image = decode_size(file_bytes(paths[i]), paths[i]);
    cameras.cameras[i].set_size(image.width, image.height, paths[i]);
    sized.push_back({cameras.cameras[i].camera.intrinsics, image.width, image.height, paths[i]});
    cameras.cameras[i].name = std::filesystem::path(paths[i]).filename().string();
  }
  check_sizes(sized);
  cameras.names_images = true;
  return cameras;
}

}  // namespace transformesh
