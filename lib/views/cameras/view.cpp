#include "views/cameras/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "support/elementary/error_function.h"
#include "support/elementary/exponential.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

// Standard deviations of the Gaussian blur in at_scale(), in pixels of the original image: this
// factor times the scale, or the second constant at scale 1. More blur removes more aliasing and
// noise, but also detail.
constexpr double blur_per_scale = 0.45;
constexpr double blur_at_scale_one = 0.6;
constexpr double deviations_kept = 3;  ///< a Gaussian is truncated at this many standard deviations

/// Describes one column or row of the shrunk image as a weighted sum of consecutive columns or rows
/// of the original image, beginning at index `first`.
struct Blend {
  int first = 0;
  std::vector<float> weights;
};

/// Filter that reduces an image by the factor `scale`: the weight of an input pixel as a function
/// of its distance from the center of an output pixel. The filter is a Gaussian. If `scale` > 1,
/// the Gaussian is convolved with a box as wide as an output pixel. The Gaussian is wider than half
/// a pixel, so that sums over pixel centers approximate integrals well.
class Kernel {
 public:
  explicit Kernel(double scale, double deviation)
      : half_area_(scale > 1 ? scale / 2 : 0), width_(deviation * std::numbers::sqrt2) {}

  double reach() const { return half_area_ + deviations_kept * width_ / std::numbers::sqrt2; }
  double operator()(double x) const {
    if (half_area_ == 0) return elementary::exp(-x * x / (width_ * width_));
    return elementary::erf((x + half_area_) / width_) - elementary::erf((x - half_area_) / width_);
  }

 private:
  double half_area_;
  double width_;
};

Blend blend_at(double center, int size, const Kernel& kernel) {
  const int first = static_cast<int>(std::ceil(center - kernel.reach()));
  const int last = static_cast<int>(std::floor(center + kernel.reach()));
  const int first_inside = std::clamp(first, 0, size - 1);
  const int last_inside = std::clamp(last, 0, size - 1);
  std::vector<double> weights(static_cast<std::size_t>(last_inside - first_inside + 1), 0);
  double sum = 0;
  for (int i = first; i <= last; ++i) {
    const int inside = std::clamp(i, first_inside, last_inside);
    const double weight = kernel(i - center);
    weights[static_cast<std::size_t>(inside - first_inside)] += weight;
    sum += weight;
  }
  for (double& weight : weights) weight /= sum;
  return {first_inside, {weights.begin(), weights.end()}};
}

std::vector<Blend> blends(int size, double scale, const Kernel& kernel) {
  const int count = static_cast<int>(std::floor(size / scale + 1e-9));
  if (count < 1) throw UsageError("an image has no pixel left at this scale");
  std::vector<Blend> result;
  result.reserve(static_cast<std::size_t>(count));
  for (int place = 0; place < count; ++place)
    result.push_back(blend_at((place + 0.5) * scale - 0.5, size, kernel));
  return result;
}

/// Writes the weighted sum of several rows of the larger image to `sum`. blend_columns() then
/// combines columns of this sum.
void blend_rows(const GrayImage& image, const Blend& blend, std::vector<float>& sum) {
  std::fill(sum.begin(), sum.end(), 0.0F);
  for (std::size_t k = 0; k < blend.weights.size(); ++k) {
    const float weight = blend.weights[k];
    const float* row = image.row(blend.first + static_cast<int>(k));
    for (std::size_t x = 0; x < sum.size(); ++x) sum[x] += weight * row[x];
  }
}

float blend_columns(const std::vector<float>& row, const Blend& blend) {
  float sum = 0;
  for (std::size_t k = 0; k < blend.weights.size(); ++k)
    sum += blend.weights[k] * row[static_cast<std::size_t>(blend.first) + k];
  return sum;
}

GrayImage resampled(const GrayImage& image, double scale, double deviation) {
  if (!(scale >= 1)) throw UsageError("a scale is at least 1");
  const Kernel kernel(scale, deviation);
  const std::vector<Blend> columns = blends(image.width, scale, kernel);
  const std::vector<Blend> rows = blends(image.height, scale, kernel);
  GrayImage result(static_cast<int>(columns.size()), static_cast<int>(rows.size()));
  std::vector<float> blended(static_cast<std::size_t>(image.width));
  for (int y = 0; y < result.height; ++y) {
    blend_rows(image, rows[static_cast<std::size_t>(y)], blended);
    for (int x = 0; x < result.width; ++x)
      result.at(x, y) = blend_columns(blended, columns[static_cast<std::size_t>(x)]);
  }
  return result;
}

/// Returns the weights of the noise-reducing blur that at_scale() applies at scale 1. The Gaussian
/// is truncated to one pixel on both sides, so that it has three weights (taps).
ThreeTapBlur taps_at_scale_one() {
  const Kernel kernel(1, blur_at_scale_one);
  constexpr int size = 3;  // the pixel and its two neighbors
  const auto weights = [&]<std::size_t count>(int place, std::array<float, count>& taps) {
    const Blend blend = blend_at(place, size, kernel);
    std::copy_n(blend.weights.begin(), count, taps.begin());
  };
  ThreeTapBlur taps;
  weights(0, taps.first);
  weights(1, taps.inside);
  weights(2, taps.last);
  return taps;
}

/// Returns the image, blurred and shrunk as by at_scale(). The result is packed (packable_image.h)
/// if `image` is packed.
PackableImage held_at_scale(const PackableImage& image, double scale) {
  PackableImage result = scale == 1 ? image : PackableImage();
  if (scale == 1 && result.blur_when_read(taps_at_scale_one())) return result;
  result = at_scale(image.unpacked(), scale);
  if (image.is_packed()) result.pack();
  return result;
}

}  // namespace

std::vector<PinholeCamera> cameras_of(std::span<const View> views) {
  std::vector<PinholeCamera> cameras;
  for (const View& view : views) cameras.push_back(view.camera);
  return cameras;
}

GrayImage at_scale(const GrayImage& image, double scale) {
  return resampled(image, scale, scale > 1 ? blur_per_scale * scale : blur_at_scale_one);
}

View at_scale(const View& view, double scale) {
  View result{view.name, view.camera.shrunk(scale), held_at_scale(view.image, scale), {}};
  if (view.silhouette.empty()) return result;
  result.silhouette = view.silhouette;
  if (scale > 1) result.silhouette = at_scale(view.silhouette.unpacked(), scale);
  if (view.silhouette.is_packed()) result.silhouette.pack();
  return result;
}

View cropped(const View& view, int column, int row, int columns, int rows) {
  View part{view.name, view.camera, {}, {}};
  part.camera.intrinsics(0, 2) -= column;
  part.camera.intrinsics(1, 2) -= row;
  if (!view.image.empty()) part.image = view.image.cropped(column, row, columns, rows);
  if (!view.silhouette.empty())
    part.silhouette = view.silhouette.cropped(column, row, columns, rows);
  return part;
}

}  // namespace transformesh
