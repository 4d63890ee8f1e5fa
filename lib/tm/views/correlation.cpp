#include "tm/views/correlation.h"

#include <Eigen/Core>
#include <array>
#include <bit>
#include <vector>

#include "tm/support/error.h"

namespace transformesh {
namespace {

using Row = Eigen::ArrayXf;

/// The last rows of several images, and zeros to either side of each.
class RowRing {
 public:
  RowRing(int rows, int width, int planes, int padding)
      : mask_(std::bit_ceil(static_cast<unsigned>(rows)) - 1),
        stride_(static_cast<std::size_t>(width + 2 * padding)),
        padding_(static_cast<std::size_t>(padding)),
        planes_(static_cast<std::size_t>(planes)),
        values_((mask_ + 1) * planes_ * stride_, 0.0F) {}

  float* row(int plane, int y) { return values_.data() + start(plane, y) + padding_; }
  const float* row(int plane, int y) const { return values_.data() + start(plane, y) + padding_; }
  void clear(int y) {
    for (std::size_t i = 0; i < planes_ * stride_; ++i) values_[start(0, y) + i] = 0;
  }

 private:
  std::size_t start(int plane, int y) const {
    const std::size_t slot = static_cast<unsigned>(y) & mask_;
    return (slot * planes_ + static_cast<std::size_t>(plane)) * stride_;
  }
  std::size_t mask_, stride_, padding_, planes_;
  std::vector<float> values_;
};

/// out[x] is the sum of in[x - radius] to in[x + radius].
template <int radius>
void sum_across(const float* __restrict in, float* __restrict out, int width) {
  for (int x = 0; x < width; ++x) {
    float sum = 0;
    for (int k = -radius; k <= radius; ++k) sum += in[x + k];
    out[x] = sum;
  }
}

enum Compared { is_seen, first, second, slope, compared_planes };
enum Factor { of_first, of_second, constant, of_square, factor_planes };
enum Moment { count, sum1, sum2, sum11, sum22, sum12, moments };

template <int radius>
class Correlation {
 public:
  Correlation(int width, const CorrelationOptions& options)
      : width_(width),
        options_(options),
        compared_(rows, width, compared_planes, radius),
        factors_(rows, width, factor_planes, radius),
        column_(Row::Zero(width + 2 * radius)) {
    for (Row& row : sums_) row = Row::Zero(width);
    for (Row& row : factor_sums_) row = Row::Zero(width);
    gradient_ = curvature_ = Row::Zero(width);
  }

  CorrelationSums run(int first_row, int end_row,
                      const std::function<void(int, const ComparedRow&)>& fill,
                      const std::function<void(int, const CorrelationRow&)>& take) {
    for (int y = first_row; y < end_row + 2 * radius; ++y) {
      compared_.clear(y);
      if (y < end_row) {
        fill(y, {compared_.row(is_seen, y), compared_.row(first, y), compared_.row(second, y),
                 compared_.row(slope, y)});
      }
      factors_.clear(y - radius);
      if (y - radius >= first_row && y - radius < end_row) compare(y - radius);
      if (y - 2 * radius >= first_row) {
        differentiate(y - 2 * radius);
        take(y - 2 * radius,
             {compared_.row(is_seen, y - 2 * radius), gradient_.data(), curvature_.data()});
      }
    }
    return totals_;
  }

 private:
  static constexpr int rows = 2 * radius + 1;

  /// The moments of all windows of row y.
  void sum_windows(int y) {
    std::array<const float*, rows> seen, one, two;
    for (int k = 0; k < rows; ++k) {
      seen[k] = compared_.row(is_seen, y + k - radius);
      one[k] = compared_.row(first, y + k - radius);
      two[k] = compared_.row(second, y + k - radius);
    }
    sum_columns(seen, count);
    sum_columns(one, sum1);
    sum_columns(two, sum2);
    sum_columns(one, one, sum11);
    sum_columns(two, two, sum22);
    sum_columns(one, two, sum12);
  }

  void sum_columns(const std::array<const float*, rows>& in, Moment moment) {
    float* __restrict out = column_.data() + radius;
    for (int x = 0; x < width_; ++x) {
      float sum = 0;
      for (int k = 0; k < rows; ++k) sum += in[k][x];
      out[x] = sum;
    }
    sum_across<radius>(out, sums_[moment].data(), width_);
  }

  void sum_columns(const std::array<const float*, rows>& a, const std::array<const float*, rows>& b,
                   Moment moment) {
    float* __restrict out = column_.data() + radius;
    for (int x = 0; x < width_; ++x) {
      float sum = 0;
      for (int k = 0; k < rows; ++k) sum += a[k][x] * b[k][x];
      out[x] = sum;
    }
    sum_across<radius>(out, sums_[moment].data(), width_);
  }

  /// The energy of row y, and what its windows contribute to the derivative at their pixels.
  void compare(int y) {
    sum_windows(y);
    const float noise = static_cast<float>(options_.noise_variance);
    const float contrast = static_cast<float>(options_.contrast);
    constexpr float half = 0.5F * rows * rows;
    const float* __restrict seen = compared_.row(is_seen, y);
    const float* __restrict n = sums_[count].data();
    const float* __restrict s1 = sums_[sum1].data();
    const float* __restrict s2 = sums_[sum2].data();
    const float* __restrict s11 = sums_[sum11].data();
    const float* __restrict s22 = sums_[sum22].data();
    const float* __restrict s12 = sums_[sum12].data();
    float* __restrict to_first = factors_.row(of_first, y);
    float* __restrict to_second = factors_.row(of_second, y);
    float* __restrict to_constant = factors_.row(constant, y);
    float* __restrict to_square = factors_.row(of_square, y);
    float* __restrict energy = gradient_.data();
    float* __restrict weight = curvature_.data();
    for (int x = 0; x < width_; ++x) {
      const float inverse = 1 / std::max(n[x], 1.0F);
      const float mean1 = s1[x] * inverse;
      const float mean2 = s2[x] * inverse;
      const float v1 = s11[x] * inverse - mean1 * mean1 + noise;
      const float v2 = s22[x] * inverse - mean2 * mean2 + noise;
      const float v12 = s12[x] * inverse - mean1 * mean2;
      const float inverse_v2 = 1 / v2;
      const float inverse_deviations = 1 / std::sqrt(v1 * v2);
      const float correlation = v12 * inverse_deviations;
      const float least = std::min(v1, v2);
      const float counted = n[x] > half ? seen[x] : 0.0F;
      const float rho = counted * least / (least + contrast);
      const float share = rho * inverse;
      energy[x] = rho * (1 - correlation);
      weight[x] = rho;
      to_first[x] = -share * inverse_deviations;
      to_second[x] = share * correlation * inverse_v2;
      to_constant[x] = share * (mean1 * inverse_deviations - mean2 * correlation * inverse_v2);
      to_square[x] = share * inverse_v2;
    }
    totals_.energy += gradient_.cast<double>().sum();
    totals_.weight += curvature_.cast<double>().sum();
    for (int x = 0; x < width_; ++x) totals_.pixels += weight[x] > 0;
  }

  void differentiate(int y) {
    for (int plane = 0; plane < factor_planes; ++plane) {
      std::array<const float*, rows> in;
      for (int k = 0; k < rows; ++k) in[k] = factors_.row(plane, y + k - radius);
      float* __restrict out = column_.data() + radius;
      for (int x = 0; x < width_; ++x) {
        float sum = 0;
        for (int k = 0; k < rows; ++k) sum += in[k][x];
        out[x] = sum;
      }
      sum_across<radius>(out, factor_sums_[plane].data(), width_);
    }
    const auto row = [&](Compared plane) {
      return Eigen::Map<const Row>(compared_.row(plane, y), width_);
    };
    gradient_ = row(slope) * (factor_sums_[of_first] * row(first) +
                              factor_sums_[of_second] * row(second) + factor_sums_[constant]);
    curvature_ = row(slope).square() * factor_sums_[of_square];
  }

  int width_;
  CorrelationOptions options_;
  RowRing compared_;
  RowRing factors_;
  Row column_;  ///< sums over columns of a window, with zeros to either side
  std::array<Row, moments> sums_;
  std::array<Row, factor_planes> factor_sums_;
  Row gradient_, curvature_;
  CorrelationSums totals_;
};

template <int radius>
CorrelationSums run(int width, int first_row, int end_row, const CorrelationOptions& options,
                    const std::function<void(int, const ComparedRow&)>& fill,
                    const std::function<void(int, const CorrelationRow&)>& take) {
  return Correlation<radius>(width, options).run(first_row, end_row, fill, take);
}

}  // namespace

CorrelationSums correlate(int width, int first_row, int end_row, const CorrelationOptions& options,
                          const std::function<void(int, const ComparedRow&)>& fill,
                          const std::function<void(int, const CorrelationRow&)>& take) {
  static constexpr std::array runs{run<1>, run<2>, run<3>, run<4>, run<5>};
  if (options.radius < 1 || options.radius > 5) throw UsageError("a window's radius is 1 to 5");
  if (!(options.noise_variance > 0)) throw UsageError("the variance of noise is to be above 0");
  if (!(options.contrast >= 0)) throw UsageError("the contrast is to be at least 0");
  if (width < 1 || first_row >= end_row) return {};
  return runs[static_cast<std::size_t>(options.radius - 1)](width, first_row, end_row, options,
                                                            fill, take);
}

}  // namespace transformesh
