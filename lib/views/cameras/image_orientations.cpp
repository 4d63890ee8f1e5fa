#include "views/cameras/image_orientations.h"

#include "io/streams/file_list.h"
#include "support/counted.h"
#include "transformesh/errors.h"
#include "views/images/exif_orientation.h"
#include "views/images/image_file.h"

namespace transformesh {
namespace {

/// Orientations 5 to 8 of Exif exchange width and height.
constexpr int first_exchanging_sides = 5;

std::string sides_text(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

/// Throws InputError if the camera's image size equals the size of the picture after rotation by
/// its Exif orientation. In this case, the camera was not calibrated for the stored pixels.
void check_camera(const std::string& path, const std::string& bytes, int orientation,
                  const CameraRecord& camera) {
  if (orientation < first_exchanging_sides || camera.width == camera.height) return;
  const GrayImage stored = decode_size(bytes, path);
  if (camera.width != stored.height || camera.height != stored.width) return;
  throw InputError(path + ": pixels are stored as " + sides_text(stored.width, stored.height) +
                   ", but the camera was calibrated for the picture as displayed, " +
                   sides_text(camera.width, camera.height) + " (" + camera.place +
                   "): rotate the pixels with mogrify -auto-orient");
}

}  // namespace

void check_orientations(const std::vector<std::string>& paths, const CameraList& cameras,
                        const ViewSources& sources) {
  std::vector<std::string> turned;
  bool is_size_known = true;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    // Read whole files. JPEG has Exif data in at most 64 kB before the pixels, but TIFF may have
    // its directory at the end.
    const std::string bytes = file_bytes(paths[i]);
    const int orientation = exif_orientation(bytes);
    if (orientation == 1) continue;
    const CameraRecord& camera = cameras.cameras[i];
    check_camera(paths[i], bytes, orientation, camera);
    is_size_known =
        is_size_known && orientation >= first_exchanging_sides && camera.width != camera.height;
    turned.push_back(paths[i]);
  }
  if (turned.empty() || !sources.on_note) return;
  sources.on_note(counted(turned.size(), "image") + " with an Exif orientation, the first is " +
                  turned.front() + ": pixels are used as they are stored" +
                  (is_size_known ? ", as their cameras were calibrated"
                                 : "; if cameras were calibrated for the turned pictures, rotate "
                                   "the pixels with mogrify -auto-orient"));
}

}  // namespace transformesh
