#include "views/cameras/view_files.h"

#include <algorithm>
#include <filesystem>

#include "io/streams/file_list.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "views/cameras/decode_files.h"
#include "views/cameras/image_files.h"
#include "views/cameras/image_orientations.h"
#include "views/cameras/view.h"
#include "views/cameras/view_masks.h"
#include "views/images/image_file.h"

namespace transformesh {
namespace {

namespace fs = std::filesystem;

std::string size_text(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

const PackableImage& sized_image(const View& view) {
  return view.image.empty() ? view.silhouette : view.image;
}

struct SizedCamera {
  Eigen::Matrix3d intrinsics;
  int width = 0;
  int height = 0;
  std::string path;  ///< path of the image
};

/// Throws InputError if images of different sizes have the same intrinsics.
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

/// Sets the sizes of cameras to those of their images.
void set_sizes(const std::vector<std::string>& paths, CameraList& cameras) {
  std::vector<SizedCamera> sized;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const GrayImage image = decode_size(file_bytes(paths[i]), paths[i]);
    cameras.cameras[i].set_size(image.width, image.height, paths[i]);
    sized.push_back({cameras.cameras[i].camera.intrinsics, image.width, image.height, paths[i]});
  }
  check_sizes(sized);
}

/// Pairs cameras with image files and returns the file of each camera. If pair_files() leaves out
/// cameras without an image, removes these cameras from `cameras`.
std::vector<std::string> pair_cameras(CameraList& cameras, const NamedFiles& names,
                                      const NamedFiles& files, const ViewSources& sources) {
  PairedFiles pairs = pair_files(names, files, cameras.names_images, sources);
  std::vector<CameraRecord> kept;
  for (const std::size_t i : pairs.kept) kept.push_back(std::move(cameras.cameras[i]));
  cameras.cameras = std::move(kept);
  return std::move(pairs.paths);
}

/// Resamples image and silhouette as an ideal pinhole camera would have recorded them.
void undistort(View& view, const CameraRecord& record) {
  const LensDistortion& distortion = record.distortion;
  if (distortion.is_none()) return;
  const Eigen::Matrix3d& intrinsics = record.camera.intrinsics;
  for (PackableImage* const image : {&view.image, &view.silhouette}) {
    const bool is_packed = image->is_packed();
    *image = undistorted(image->unpacked(), intrinsics, distortion);
    if (is_packed) image->pack();
  }
}

/// Shrinks the views, if `factor` is above 1.
void reduce(std::vector<View>& views, double factor) {
  if (factor == 1) return;
  parallel_for(views.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) views[i] = at_scale(views[i], factor);
  });
}

}  // namespace

std::vector<View> views_from(const ViewSources& sources) {
  CameraList list = cameras_from(sources.cameras);
  std::vector<std::string> images;
  std::vector<std::string> silhouettes;
  // If there are images, silhouettes are paired with images, not with cameras. Some camera files
  // contain no names of images, so that silhouettes could only be paired with cameras by order.
  NamedFiles leaders = names_of(list, sources.cameras);
  if (!sources.images.empty()) {
    const NamedFiles files = image_files("image", sources.images, list);
    images = pair_cameras(list, leaders, files, sources);
    leaders = {"image", sources.images, images, {}, files.root};
  }
  if (!sources.silhouettes.empty()) {
    const NamedFiles files = image_files("silhouette", sources.silhouettes, list);
    silhouettes = images.empty() ? pair_cameras(list, leaders, files, sources)
                                 : pair_files(leaders, files, false, sources).paths;
    if (images.empty()) leaders = {"silhouette", sources.silhouettes, silhouettes, {}, files.root};
  }
  std::vector<View> views(list.cameras.size());
  check_orientations(images, list, sources);
  decode_all(images, [&](std::size_t i, const std::string& bytes) {
    views[i].image = decode_photograph(bytes, images[i]);
    pack_one_of(views.size(), views[i].image);
  });
  if (!silhouettes.empty()) decode_masks(silhouettes, sources, views);

  const std::vector<std::string> stems = distinct_stems(leaders);
  std::vector<SizedCamera> sized;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const PackableImage& image = sized_image(views[i]);
    if (!image.empty()) list.cameras[i].set_size(image.width, image.height, leaders.paths[i]);
    const PinholeCamera& camera = list.cameras[i].camera;
    views[i].camera = sources.mirror ? camera.mirrored() : camera;
    sized.push_back({views[i].camera.intrinsics, image.width, image.height, leaders.paths[i]});
    views[i].name = stems[i];
    undistort(views[i], list.cameras[i]);
  }
  check_sizes(sized);
  reduce(views, sources.reduction);
  return views;
}

CameraList cameras_of_images(CameraList cameras, const ViewSources& sources) {
  const NamedFiles files = image_files("image", sources.images, cameras);
  const auto paths = pair_cameras(cameras, names_of(cameras, sources.cameras), files, sources);
  const auto stems = distinct_stems({"image", sources.images, paths, {}, files.root});
  check_orientations(paths, cameras, sources);
  set_sizes(paths, cameras);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    cameras.cameras[i].name =
        (fs::path(stems[i]).parent_path() / fs::path(paths[i]).filename()).string();
  }
  cameras.names_images = true;
  return cameras;
}

std::vector<PictureView> picture_views_from(const ViewSources& sources) {
  CameraList list = cameras_from(sources.cameras);
  const NamedFiles files = image_files("image", sources.images, list);
  const auto paths = pair_cameras(list, names_of(list, sources.cameras), files, sources);
  const auto stems = distinct_stems({"image", sources.images, paths, {}, files.root});
  check_orientations(paths, list, sources);
  set_sizes(paths, list);
  std::vector<PictureView> views;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const CameraRecord& record = list.cameras[i];
    const auto picture = [path = paths[i], lens = record.distortion,
                          intrinsics = record.camera.intrinsics] {
      return undistorted(decode_picture(file_bytes(path), path), intrinsics, lens);
    };
    views.push_back({stems[i], sources.mirror ? record.camera.mirrored() : record.camera,
                     record.width, record.height, picture});
  }
  return views;
}

}  // namespace transformesh
