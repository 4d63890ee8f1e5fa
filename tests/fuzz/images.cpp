// Image files of all supported formats. A header may announce any size: scripts/fuzz limits the
// memory of a run, and of one allocation.
#include "fuzz/fuzz.h"
#include "transformesh/errors.h"
#include "views/images/image_file.h"

using namespace transformesh;
using namespace transformesh::fuzz;

namespace {

void check_intensities(const GrayImage& image) {
  demand(image.width > 0 && image.height > 0, "an image without pixels");
  demand(image.pixels.size() ==
             static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
         "another number of pixels");
  for (const float intensity : image.pixels)
    demand(intensity >= 0 && intensity <= 255.001F, "a level beyond");
}

}  // namespace

void transformesh::fuzz::run_target(std::string_view bytes) {
  const std::string name = "input.image";
  try {
    const GrayImage image = decode_photograph(bytes, name);
    check_intensities(image);
    const GrayImage size = decode_size(bytes, name);
    demand(size.width == image.width && size.height == image.height, "another size");
    const GrayImage silhouette = decode_mask(bytes, name).silhouette;
    demand(silhouette.pixels.size() == image.pixels.size(), "a silhouette of another size");
  } catch (const InputError&) {
  }
}
