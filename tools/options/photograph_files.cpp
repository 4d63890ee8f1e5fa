#include "options/photograph_files.h"

#include <algorithm>
#include <numeric>

#include "picture/shade.h"
#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/image.h"
#include "views/cameras/camera_output.h"
#include "views/cameras/name_pairs.h"
#include "views/cameras/view.h"
#include "views/cameras/view_files.h"
#include "views/hull/silhouette.h"
#include "views/images/image_file.h"

namespace transformesh::tool {
namespace {

CameraList cameras_of(const CameraRing& ring, const PhotographFiles& files) {
  if (files.cameras.empty()) return camera_ring(ring);
  CameraList list = cameras_from(files.cameras);
  if (!files.masks.empty()) {
    ViewSources sources{files.cameras, files.masks, ""};
    sources.needs_all_images = true;
    list = cameras_of_images(std::move(list), sources);
  }
  const bool needs_size = !files.images.empty() || !files.silhouettes.empty();
  for (CameraRecord& record : list.cameras) {
    if (record.width != 0) continue;
    const bool is_partial = record.is_centered || record.unit != IntrinsicsUnit::pixel;
    if (!files.size_is_given && (needs_size || is_partial))
      throw UsageError("the camera file does not state the size of the image of " + record.name +
                       " (" + record.place + "): give --size WxH");
    record.set_size(ring.width, ring.height, "--size");
  }
  return list;
}

/// Returns distinct names for the photographs. If the file names in the camera file are not
/// distinct, the returned names contain folders.
std::vector<std::string> names_of(const CameraList& list, const PhotographFiles& files) {
  NamedFiles named{"camera", files.cameras, {}, {}};
  for (const CameraRecord& record : list.cameras) named.paths.push_back(record.name);
  std::vector<std::string> names = distinct_stems(named);
  for (std::string& name : names) name += ".png";
  return names;
}

void compare_silhouettes(const Mesh& mesh, const PhotographFiles& files, Run& run) {
  if (files.cameras.empty()) throw UsageError("--compare-silhouettes needs --cameras");
  const std::vector<View> views = views_from({files.cameras, "", files.masks});
  const std::vector<double> agreements = silhouette_agreements(mesh, views);
  for (std::size_t i = 0; i < views.size(); ++i)
    run.say().detail(views[i].name + ": agreement of the silhouettes " +
                     shortest_text(agreements[i]));
  const double sum = std::accumulate(agreements.begin(), agreements.end(), 0.0);
  run.report("silhouette_agreement", sum / static_cast<double>(views.size()));
  run.report("least_silhouette_agreement", *std::min_element(agreements.begin(), agreements.end()));
}

}  // namespace

std::string write_photographs(const Mesh& mesh, const CameraRing& ring,
                              const PhotographFiles& files, Run& run) {
  CameraList list = cameras_of(ring, files);
  const std::vector<std::string> names = names_of(list, files);
  const SolidTexture texture(files.texture);
  std::uint64_t number = 0;
  for (CameraRecord& record : list.cameras) {
    run.progress()("photograph",
                   static_cast<double>(number) / static_cast<double>(list.cameras.size()));
    const Camera camera{record.camera.projection(), record.width, record.height};
    const std::string& name = names[number];
    Photograph photograph;
    if (!files.images.empty() || !files.silhouettes.empty())
      photograph = take_photograph(mesh, camera, texture, number, files.sensor);
    if (!files.images.empty()) {
      run.out().write_into(
          files.images, name,
          write_png(files.is_shaded ? shade(mesh, camera) : picture_of(photograph.image)));
    }
    if (!files.silhouettes.empty())
      run.out().write_into(files.silhouettes, name, write_png(picture_of(photograph.silhouette)));
    record.name = name;
    ++number;
  }
  list.names_images = true;
  run.report("views", list.cameras.size());
  if (!files.masks.empty()) compare_silhouettes(mesh, files, run);
  return write_cameras(list, CameraFormat::middlebury);
}

}  // namespace transformesh::tool
