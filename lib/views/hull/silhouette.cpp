#include "views/hull/silhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "raster/camera.h"
#include "transformesh/errors.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/hull/contour_distance.h"
#include "views/images/gaussian_blur.h"

namespace transformesh {
namespace {

/// Returns the silhouette whose contour is `offset` pixels outside the contour of `distances`.
GrayImage offset_silhouette(GrayImage distances, float offset) {
  for (float& pixel : distances.pixels)
    pixel = std::clamp(contour_intensity * (1 + offset - pixel), 0.0F, 255.0F);
  return distances;
}

/// Returns the morphological closing of the silhouette: dilates and then erodes it by a disc. The
/// border of the image is not eroded, because it is not part of the contour.
GrayImage closed(const GrayImage& silhouette, float radius) {
  // Larger distances than `radius` are not needed. The distance transform needs a margin of four
  // pixels, because it propagates distances through neighbors that may be farther from the contour.
  const float limit = radius + 4;
  const GrayImage wide = offset_silhouette(signed_distance(silhouette, limit), radius);
  GrayImage narrow = offset_silhouette(signed_distance(wide, limit), -radius);
  // Keep the contour of the given silhouette at places where nothing was closed.
  for (std::size_t i = 0; i < narrow.pixels.size(); ++i)
    narrow.pixels[i] = std::max(narrow.pixels[i], silhouette.pixels[i]);
  return narrow;
}

/// Number of pixels of each intensity.
using Histogram = std::array<std::size_t, 256>;

/// Returns the largest intensity of the dark class. This is the intensity that maximizes the
/// variance between the two classes (Otsu's equation 14). Ignores divisions in which a class has
/// less than float epsilon of the pixels.
std::ptrdiff_t otsu_threshold(const Histogram& counts) {
  const double scale = 1 / std::accumulate(counts.begin(), counts.end(), 0.0);
  double mean = 0;
  for (std::size_t intensity = 0; intensity < counts.size(); ++intensity)
    mean += static_cast<double>(intensity) * static_cast<double>(counts[intensity]);
  mean *= scale;

  std::ptrdiff_t best = 0;
  double largest = 0;
  double dark_share = 0;
  double dark_mean = 0;
  for (std::size_t intensity = 0; intensity < counts.size(); ++intensity) {
    const double share = static_cast<double>(counts[intensity]) * scale;
    dark_mean *= dark_share;
    dark_share += share;
    const double bright_share = 1 - dark_share;
    if (std::min(dark_share, bright_share) < std::numeric_limits<float>::epsilon()) continue;
    dark_mean = (dark_mean + static_cast<double>(intensity) * share) / dark_share;
    const double bright_mean = (mean - dark_share * dark_mean) / bright_share;
    const double apart = dark_mean - bright_mean;
    const double variance = dark_share * bright_share * apart * apart;
    if (variance <= largest) continue;
    largest = variance;
    best = static_cast<std::ptrdiff_t>(intensity);
  }
  return best;
}

}  // namespace

double dividing_threshold(std::span<const GrayImage> images) {
  Histogram counts{};
  for (const GrayImage& image : images)
    for (const float intensity : image.pixels)
      ++counts[static_cast<std::size_t>(std::clamp(std::lround(intensity), 0L, 255L))];
  const auto is_used = [](std::size_t count) { return count > 0; };
  if (std::none_of(counts.begin(), counts.end(), is_used)) return contour_intensity;

  // The variance between the classes is the same for all thresholds in the gap between the classes.
  // Find both ends of the gap. NOLINTBEGIN(readability-qualified-auto): an iterator of an array is
  // a pointer here only
  const auto first_bright = counts.begin() + otsu_threshold(counts) + 1;
  const auto bright = std::find_if(first_bright, counts.end(), is_used);
  // NOLINTEND(readability-qualified-auto)
  const auto dark = std::find_if(std::make_reverse_iterator(first_bright), counts.rend(), is_used);
  const auto brightest_dark = std::max<std::ptrdiff_t>(dark.base() - counts.begin() - 1, 0);
  const auto darkest_bright = std::min<std::ptrdiff_t>(bright - counts.begin(), 255);
  return std::clamp(static_cast<double>(brightest_dark + darkest_bright) / 2, 0.5, 254.5);
}

GrayImage threshold_silhouette(const GrayImage& image, const ThresholdOptions& options) {
  if (options.intensity && !(*options.intensity > 0 && *options.intensity < 255))
    throw UsageError("the threshold of a silhouette must be between 0 and 255");
  if (!(options.close >= 0 && options.close <= 1))
    throw UsageError(
        "the width of gaps that are closed in a silhouette must be between 0 and 1, in image "
        "sizes");
  if (!(options.blur >= 0)) throw UsageError("the blur of a silhouette must not be negative");
  GrayImage silhouette = image;
  if (image.empty()) return silhouette;

  if (options.blur > 0) silhouette = gaussian_blur(image, options.blur);
  // Scale intensities about the threshold, which becomes 127.5. The narrower of the dark and
  // bright ranges fills half of [0, 255], and the wider one is clipped. The contour between two
  // pixels keeps its position unless one of them is clipped.
  const auto intensity = static_cast<float>(
      options.intensity ? *options.intensity : dividing_threshold({&silhouette, 1}));
  const float slope = contour_intensity / std::min(intensity, 255 - intensity);
  for (float& pixel : silhouette.pixels)
    pixel = std::clamp(contour_intensity + slope * (pixel - intensity), 0.0F, 255.0F);
  const auto radius = static_cast<float>(options.close * std::max(image.width, image.height));
  return radius > 0 ? closed(silhouette, radius) : silhouette;
}

GrayImage binary_silhouette(const GrayImage& silhouette) {
  GrayImage mask = silhouette;
  for (float& pixel : mask.pixels) pixel = is_inside_contour(pixel) ? 255.0F : 0.0F;
  return mask;
}

double inside_share(const GrayImage& silhouette) {
  const auto inside =
      std::count_if(silhouette.pixels.begin(), silhouette.pixels.end(), is_inside_contour);
  return silhouette.empty()
             ? 0.0
             : static_cast<double>(inside) / static_cast<double>(silhouette.pixels.size());
}

double silhouette_agreement(const GrayImage& first, const GrayImage& second) {
  if (first.width != second.width || first.height != second.height)
    throw UsageError("silhouettes of different sizes cannot be compared");
  std::size_t both = 0;
  std::size_t any = 0;
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    const bool is_in_first = is_inside_contour(first.pixels[i]);
    const bool is_in_second = is_inside_contour(second.pixels[i]);
    both += is_in_first && is_in_second ? 1 : 0;
    any += is_in_first || is_in_second ? 1 : 0;
  }
  return any == 0 ? 1.0 : static_cast<double>(both) / static_cast<double>(any);
}

GrayImage mesh_silhouette(const Mesh& mesh, const Camera& camera) {
  const FaceBuffer faces = rasterize(mesh, camera);
  GrayImage silhouette(camera.width, camera.height);
  for (std::size_t i = 0; i < faces.pixels.size(); ++i)
    silhouette.pixels[i] = faces.pixels[i].face == no_index ? 0.0F : 255.0F;
  return silhouette;
}

GrayImage mesh_silhouette(const Mesh& mesh, const View& view) {
  const PackableImage& image = view.image.empty() ? view.silhouette : view.image;
  return mesh_silhouette(mesh, {view.camera.projection(), image.width, image.height});
}

std::vector<double> silhouette_agreements(const Mesh& mesh, std::span<const View> views) {
  std::vector<double> agreements;
  for (const View& view : views)
    agreements.push_back(silhouette_agreement(mesh_silhouette(mesh, view), view.silhouette));
  return agreements;
}

}  // namespace transformesh
