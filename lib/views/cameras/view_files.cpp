#include "views/cameras/view_files.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <set>

#include "io/streams/file_list.h"
#include "support/counted.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "views/cameras/name_pairs.h"
#include "views/cameras/view.h"
#include "views/images/image_file.h"

namespace transformesh {
namespace {

namespace fs = std::filesystem;

/// Returns the existing folders of images below `where`, according to the names of cameras.
std::vector<std::string> image_folders(const CameraList& cameras, const std::string& where) {
  std::set<std::string> folders;
  for (const CameraRecord& record : cameras.cameras) {
    const fs::path folder = fs::path(record.name).parent_path().lexically_normal();
    const bool leads_out = folder.is_absolute() || (!folder.empty() && *folder.begin() == "..");
    if (!leads_out) folders.insert((fs::path(where) / folder).string());
  }
  std::erase_if(folders, [](const std::string& folder) { return !is_folder(folder); });
  return {folders.begin(), folders.end()};
}

/// Returns the folder, or the folder in which a pattern begins.
std::string root_of(const std::string& where) {
  if (is_folder(where)) return where;
  const std::string start = where.substr(0, where.find_first_of("*?["));
  return start.substr(0, start.rfind('/') + 1);
}

NamedFiles image_files(const std::string& kind, const std::string& where,
                       const CameraList& cameras) {
  NamedFiles files{kind, where, {}, {}, root_of(where)};
  const bool has_folders =
      is_folder(where) &&
      std::any_of(cameras.cameras.begin(), cameras.cameras.end(), [](const CameraRecord& record) {
        return record.name.find('/') != std::string::npos;
      });
  std::vector<std::string> folders;
  if (has_folders) folders = image_folders(cameras, where);
  if (folders.empty()) folders = {where};
  for (const std::string& folder : folders) {
    const std::vector<std::string> paths = files_at(folder);
    files.paths.insert(files.paths.end(), paths.begin(), paths.end());
  }
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

/// Returns the paths of `files` in the order of their partners in `names`.
std::vector<std::string> ordered(const NamedFiles& names, const NamedFiles& files,
                                 bool names_must_agree) {
  std::vector<std::string> paths;
  for (const std::size_t i : pair_by_name(names, files, names_must_agree)) {
    paths.push_back(files.paths[i]);
  }
  return paths;
}

/// Decodes all files; `decode` gets the index of each. If several files are bad, always reports the
/// first one.
template <typename Decode>
void decode_all(const std::vector<std::string>& paths, const Decode& decode) {
  std::vector<std::exception_ptr> failures(paths.size());
  parallel_for(paths.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      try {
        decode(i, file_bytes(paths[i]));
      } catch (const InputError&) {
        failures[i] = std::current_exception();
      }
    }
  });
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

/// Returns "PATH", or "PATH and N further masks" for `count` files.
std::string and_others(const std::string& path, std::size_t count) {
  return count == 1 ? path : path + " and " + counted(count - 1, "further mask");
}

void note_mask_rule(const std::vector<std::string>& paths, const std::vector<MaskRule>& rules,
                    MaskRule rule, const std::string& text, const ViewSources& sources) {
  const auto count = std::count(rules.begin(), rules.end(), rule);
  if (count == 0 || !sources.on_note) return;
  const auto first = std::find(rules.begin(), rules.end(), rule) - rules.begin();
  sources.on_note(
      and_others(paths[static_cast<std::size_t>(first)], static_cast<std::size_t>(count)) + text);
}

/// Packs the image if `count` such images would be large. Unpacked images are faster to read.
void pack_one_of(std::size_t count, PackableImage& image) {
  constexpr double most_pixels = 8e6;  ///< 32 MB of floats
  if (static_cast<double>(count) * image.width * image.height > most_pixels) image.pack();
}

void decode_masks(const std::vector<std::string>& paths, const ViewSources& sources,
                  std::vector<View>& views) {
  std::vector<MaskRule> rules(paths.size());
  decode_all(paths, [&](std::size_t i, const std::string& bytes) {
    Mask mask = decode_mask(bytes, paths[i]);
    views[i].silhouette = std::move(mask.silhouette);
    pack_one_of(views.size(), views[i].silhouette);
    rules[i] = mask.rule;
  });
  note_mask_rule(paths, rules, MaskRule::alpha,
                 ": transparency is the mask: the object is where the picture is opaque", sources);
  note_mask_rule(
      paths, rules, MaskRule::between_intensities,
      ": black and white are not quite that, as noise or JPEG leave them: the object is what "
      "is brighter than half-way between",
      sources);
}

std::string size_text(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

std::string size_text(const PackableImage& image) { return size_text(image.width, image.height); }

bool is_size_equal(const PackableImage& first, const PackableImage& second) {
  return first.width == second.width && first.height == second.height;
}

void check_silhouette(const View& view, const std::string& path) {
  if (!view.image.empty() && !is_size_equal(view.image, view.silhouette)) {
    throw InputError(path + ": the silhouette has " + size_text(view.silhouette) +
                     ", but its image has " + size_text(view.image));
  }
  for (int y = 0; y < view.silhouette.height; ++y)
    for (int x = 0; x < view.silhouette.width; ++x)
      if (view.silhouette.at(x, y) != 0) return;
  throw InputError(path + ": the silhouette is empty: no pixel is inside");
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

/// Throws if images of different sizes have the same intrinsics.
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

}  // namespace

std::vector<View> views_from(const ViewSources& sources) {
  CameraList list = cameras_from(sources.cameras);
  const NamedFiles names = names_of(list, sources.cameras);
  std::vector<std::string> images;
  std::vector<std::string> silhouettes;
  std::vector<View> views(list.cameras.size());

  // Silhouettes are paired with images rather than with cameras. Matrix files contain no names of
  // images, so that silhouettes could then only be paired by order.
  NamedFiles leaders = names;
  if (!sources.images.empty()) {
    const NamedFiles files = image_files("image", sources.images, list);
    images = ordered(names, files, list.names_images);
    decode_all(images, [&](std::size_t i, const std::string& bytes) {
      views[i].image = decode_photograph(bytes, images[i]);
      pack_one_of(views.size(), views[i].image);
    });
    leaders = {"image", sources.images, images, {}, files.root};
  }
  if (!sources.silhouettes.empty()) {
    const bool names_must_agree = images.empty() && list.names_images;
    const NamedFiles files = image_files("silhouette", sources.silhouettes, list);
    silhouettes = ordered(leaders, files, names_must_agree);
    decode_masks(silhouettes, sources, views);
    if (images.empty()) leaders = {"silhouette", sources.silhouettes, silhouettes, {}, files.root};
  }

  const std::vector<std::string> stems = distinct_stems(leaders);
  std::vector<SizedCamera> sized;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const PackableImage& image = sized_image(views[i]);
    if (!image.empty()) list.cameras[i].set_size(image.width, image.height, leaders.paths[i]);
    const PinholeCamera& camera = list.cameras[i].camera;
    views[i].camera = sources.mirror ? camera.mirrored() : camera;
    sized.push_back({views[i].camera.intrinsics, image.width, image.height, leaders.paths[i]});
    views[i].name = stems[i];
    if (!silhouettes.empty()) check_silhouette(views[i], silhouettes[i]);
    undistort(views[i], list.cameras[i]);
  }
  check_sizes(sized);
  return views;
}

CameraList cameras_of_images(CameraList cameras, const std::string& where,
                             const std::string& images) {
  const NamedFiles files = image_files("image", images, cameras);
  const auto paths = ordered(names_of(cameras, where), files, cameras.names_images);
  const auto stems = distinct_stems({"image", images, paths, {}, files.root});
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
  const auto paths = ordered(names_of(list, sources.cameras), files, list.names_images);
  const auto stems = distinct_stems({"image", sources.images, paths, {}, files.root});
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
