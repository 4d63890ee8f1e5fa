#include "views/images/gaussian_blur.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "support/elementary/exponential.h"
#include "transformesh/image.h"

namespace transformesh {
namespace {

/// The intensities of a row of pixels, with unused elements at the end so that whole blocks can be
/// read.
using Row = std::vector<double>;

/// Number of pixels whose sums are computed together, in registers.
constexpr std::size_t block = 16;

Row make_row(int width) { return Row(static_cast<std::size_t>(width) + block); }

/// Returns the weights of a Gaussian, rounded to floats. Their number is odd, and the middle one is
/// the largest.
std::vector<double> gaussian_weights(double deviation) {
  const auto reach = static_cast<int>(std::lrint(8 * deviation + 1)) / 2;
  std::vector<double> weights;
  for (int i = -reach; i <= reach; ++i)
    weights.push_back(elementary::exp(-0.5 * i * i / (deviation * deviation)));
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight = static_cast<float>(weight / sum);
  return weights;
}

/// Returns the index of the pixel that replaces pixel `i` of a row that is mirrored at its ends.
int mirrored(int i, int count) {
  if (count == 1) return 0;
  const int period = 2 * (count - 1);
  const int place = std::abs(i) % period;
  return std::min(place, period - place);
}

/// Writes the sum over i of weights[i] * rows[i][x] to result[x]. Products of floats are exact in
/// double precision, so that each addition is rounded only once, to a float. The result equals that
/// of fused multiply-add instructions for floats, also on machines without them.
void weigh(const std::vector<double>& weights, const std::vector<const double*>& rows, int width,
           float* result) {
  for (std::size_t x = 0; x < static_cast<std::size_t>(width); x += block) {
    std::array<float, block> sums{};
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double* intensities = rows[i] + x;
      for (std::size_t j = 0; j < block; ++j)
        sums[j] = static_cast<float>(weights[i] * intensities[j] + static_cast<double>(sums[j]));
    }
    const std::size_t count = std::min(block, static_cast<std::size_t>(width) - x);
    std::copy_n(sums.begin(), count, result + x);
  }
}

GrayImage blur_rows(const GrayImage& image, const std::vector<double>& weights) {
  GrayImage result(image.width, image.height);
  const int reach = static_cast<int>(weights.size()) / 2;
  Row wide = make_row(image.width + 2 * reach);
  std::vector<const double*> rows;
  for (std::size_t i = 0; i < weights.size(); ++i) rows.push_back(wide.data() + i);
  for (int y = 0; y < image.height; ++y) {
    const float* row = image.row(y);
    std::copy_n(row, image.width, wide.begin() + reach);
    for (int i = 1; i <= reach; ++i) {
      wide[static_cast<std::size_t>(reach - i)] = row[mirrored(-i, image.width)];
      wide[static_cast<std::size_t>(image.width) + static_cast<std::size_t>(reach - 1 + i)] =
          row[mirrored(image.width - 1 + i, image.width)];
    }
    weigh(weights, rows, image.width, result.row(y));
  }
  return result;
}

/// Blurs along columns. Rows at the same distance above and below a pixel are added first, because
/// they have the same weight.
GrayImage blur_columns(const GrayImage& image, const std::vector<double>& weights) {
  GrayImage result(image.width, image.height);
  const std::vector<double> half(weights.begin() + static_cast<int>(weights.size() / 2),
                                 weights.end());
  std::vector<Row> sums(half.size(), make_row(image.width));
  std::vector<const double*> rows;
  rows.reserve(sums.size());
  for (const Row& sum : sums) rows.push_back(sum.data());
  for (int y = 0; y < image.height; ++y) {
    std::copy_n(image.row(y), image.width, sums[0].begin());
    for (int i = 1; i < static_cast<int>(half.size()); ++i) {
      const float* above = image.row(mirrored(y - i, image.height));
      const float* below = image.row(mirrored(y + i, image.height));
      std::transform(below, below + image.width, above, sums[static_cast<std::size_t>(i)].begin(),
                     std::plus<>());
    }
    weigh(half, rows, image.width, result.row(y));
  }
  return result;
}

}  // namespace

GrayImage gaussian_blur(const GrayImage& image, double deviation) {
  const std::vector<double> weights = gaussian_weights(deviation);
  return blur_columns(blur_rows(image, weights), weights);
}

}  // namespace transformesh
