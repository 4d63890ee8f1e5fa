#include "views/cameras/view_masks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "support/counted.h"
#include "transformesh/errors.h"
#include "views/cameras/decode_files.h"
#include "views/images/image_file.h"

namespace transformesh {
namespace {

/// Returns "PATH", or "PATH and N further masks" for `count` files.
std::string and_others(const std::string& path, std::size_t count) {
  return count == 1 ? path : path + " and " + counted(count - 1, "further mask");
}

/// Reports masks that have a certain property, such as being scaled. `properties` has one value per
/// mask. If any value equals `property`, calls `sources.on_note` once. The message contains the
/// path of the first such mask, the number of further masks, and `text`.
template <class Property>
void note_masks(const std::vector<std::string>& paths, const std::vector<Property>& properties,
                Property property, const std::string& text, const ViewSources& sources) {
  const auto count = std::count(properties.begin(), properties.end(), property);
  if (count == 0 || !sources.on_note) return;
  const auto first = std::find(properties.begin(), properties.end(), property) - properties.begin();
  sources.on_note(
      and_others(paths[static_cast<std::size_t>(first)], static_cast<std::size_t>(count)) + text);
}

/// A mask is scaled to the size of its photograph only if the widths differ by at least this
/// factor. If they differ by less, the mask was probably cropped, and scaling would misalign it.
constexpr double least_scale = 1.25;

/// True if mask and photograph differ in size but not in aspect ratio. Tolerates sides that were
/// rounded to whole pixels.
bool is_scaled_size(const GrayImage& mask, const PackableImage& photograph) {
  if (photograph.empty()) return false;
  const double ratio = static_cast<double>(mask.width) / photograph.width;
  const auto product = [](int a, int b) { return static_cast<double>(a) * b; };
  const double difference =
      std::abs(product(mask.width, photograph.height) - product(mask.height, photograph.width));
  return std::max(ratio, 1 / ratio) >= least_scale &&
         difference <= std::max(photograph.width, photograph.height);
}

/// Scales the mask by bilinear interpolation, with the areas of pixels aligned. Pixels above half
/// of the full intensity are inside.
GrayImage scaled(const GrayImage& mask, int width, int height) {
  const auto place = [](int target, int from, int to) {
    return std::clamp((target + 0.5) * from / to - 0.5, 0.0, from - 1.0);
  };
  GrayImage result(width, height);
  for (int y = 0; y < height; ++y) {
    const double v = place(y, mask.height, height);
    const int row = std::min(static_cast<int>(v), std::max(0, mask.height - 2));
    const int next_row = std::min(row + 1, mask.height - 1);
    for (int x = 0; x < width; ++x) {
      const double u = place(x, mask.width, width);
      const int column = std::min(static_cast<int>(u), std::max(0, mask.width - 2));
      const int next_column = std::min(column + 1, mask.width - 1);
      const double s = u - column;
      const double t = v - row;
      const double top = mask.at(column, row) * (1 - s) + mask.at(next_column, row) * s;
      const double low = mask.at(column, next_row) * (1 - s) + mask.at(next_column, next_row) * s;
      result.at(x, y) = top * (1 - t) + low * t > 127.5 ? 255.0F : 0.0F;
    }
  }
  return result;
}

std::string mask_size_text(const PackableImage& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels";
}

bool is_size_equal(const PackableImage& first, const PackableImage& second) {
  return first.width == second.width && first.height == second.height;
}

void check_silhouette(const View& view, const std::string& path) {
  if (!view.image.empty() && !is_size_equal(view.image, view.silhouette)) {
    throw InputError(path + ": the silhouette has " + mask_size_text(view.silhouette) +
                     ", but its image has " + mask_size_text(view.image));
  }
  for (int y = 0; y < view.silhouette.height; ++y)
    for (int x = 0; x < view.silhouette.width; ++x)
      if (view.silhouette.at(x, y) != 0) return;
  throw InputError(path + ": the silhouette is empty: no pixel is inside");
}

}  // namespace

void decode_masks(const std::vector<std::string>& paths, const ViewSources& sources,
                  std::vector<View>& views) {
  std::vector<MaskRule> rules(paths.size());
  std::vector<char> is_scaled(paths.size());
  decode_all(paths, [&](std::size_t i, const std::string& bytes) {
    Mask mask = decode_mask(bytes, paths[i]);
    const PackableImage& image = views[i].image;
    is_scaled[i] = is_scaled_size(mask.silhouette, image) ? 1 : 0;
    if (is_scaled[i] != 0) mask.silhouette = scaled(mask.silhouette, image.width, image.height);
    views[i].silhouette = std::move(mask.silhouette);
    pack_one_of(views.size(), views[i].silhouette);
    rules[i] = mask.rule;
    check_silhouette(views[i], paths[i]);
  });
  note_masks(paths, is_scaled, char{1}, ": scaled to the size of the photograph", sources);
  note_masks(paths, rules, MaskRule::alpha,
             ": transparency is used as the mask: opaque pixels show the object", sources);
  note_masks(paths, rules, MaskRule::between_intensities,
             ": the mask is not purely black and white, as after noise or JPEG compression: "
             "pixels brighter than halfway between the darkest and the brightest show the object",
             sources);
}

}  // namespace transformesh
