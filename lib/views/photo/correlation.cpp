#include "views/photo/correlation.h"

#include <Eigen/Core>
#include <array>
#include <bit>
#include <vector>

#include "transformesh/errors.h"

namespace transformesh {
namespace {

using Row = Eigen::ArrayXf;

/// Ring buffer that stores the last rows of several images (planes). Each row is padded with zeros
/// on both sides.
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

/// Sets out[x] to the sum of in[x - radius] to in[x + radius].
template <int radius>
void sum_across(const float* __restrict in, float* __restrict out, int width) {
  for (int x = 0; x < width; ++x) {
    float sum = 0;
    for (int k = -radius; k <= radius; ++k) sum += in[x + k];
    out[x] = sum;
  }
}

enum ComparedPlane { is_seen, first, second, slope, compared_planes };
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
    weight_ = Row::Zero(width);
  }

  CorrelationSums run(int first_row, int end_row,
                      const std::function<void(int, const ComparedRow&)>& fill,
                      const std::function<void(int, const CorrelationRow&)>& take,
                      const std::function<void(int, const WindowRow&)>& look) {
    for (int y = first_row; y < end_row + 2 * radius; ++y) {
      compared_.clear(y);
      if (y < end_row) {
        fill(y, {compared_.row(is_seen, y), compared_.row(first, y), compared_.row(second, y),
                 compared_.row(slope, y)});
      }
      if (take) factors_.clear(y - radius);
      if (y - radius >= first_row && y - radius < end_row) {
        compare(y - radius);
        if (take) keep_factors(y - radius);
        if (look) look(y - radius, {weight_.data(), energy_.data(), deviations_.data()});
      }
      if (take && y - 2 * radius >= first_row) {
        differentiate(y - 2 * radius);
        take(y - 2 * radius,
             {compared_.row(is_seen, y - 2 * radius), gradient_.data(), curvature_.data()});
      }
    }
    return totals_;
  }

 private:
  static constexpr int rows = 2 * radius + 1;  ///< number of rows of a window

  using Rows = std::array<const float*, rows>;

  /// Returns those rows of an image (plane) that are in windows around row `y`.
  Rows reach(const RowRing& ring, int plane, int y) const {
    Rows result;
    for (int k = 0; k < rows; ++k)
      result[static_cast<std::size_t>(k)] = ring.row(plane, y + k - radius);
    return result;
  }

  /// Sets `out` to the sums of `term` over the window around each pixel of a row.
  template <typename Term>
  void sum_windows(const Term& term, Row& out) {
    float* __restrict column = column_.data() + radius;
    for (int x = 0; x < width_; ++x) {
      float sum = 0;
      for (std::size_t k = 0; k < rows; ++k) sum += term(k, x);
      column[x] = sum;
    }
    sum_across<radius>(column, out.data(), width_);
  }

  void find_moments(int y) {
    const Rows n = reach(compared_, is_seen, y);
    const Rows a = reach(compared_, first, y);
    const Rows b = reach(compared_, second, y);
    sum_windows([&](std::size_t k, int x) { return n[k][x]; }, sums_[count]);
    sum_windows([&](std::size_t k, int x) { return a[k][x]; }, sums_[sum1]);
    sum_windows([&](std::size_t k, int x) { return b[k][x]; }, sums_[sum2]);
    sum_windows([&](std::size_t k, int x) { return a[k][x] * a[k][x]; }, sums_[sum11]);
    sum_windows([&](std::size_t k, int x) { return b[k][x] * b[k][x]; }, sums_[sum22]);
    sum_windows([&](std::size_t k, int x) { return a[k][x] * b[k][x]; }, sums_[sum12]);
  }

  /// Sets `weight_` to the weight of each window (rho in correlation.h), and to 0 for windows of
  /// which at most half is visible.
  void find_weights(int y) {
    constexpr float half = 0.5F * rows * rows;  // number of pixels of half a window
    const float* __restrict seen = compared_.row(is_seen, y);
    const float* __restrict n = sums_[count].data();
    float* __restrict weight = weight_.data();
    for (int x = 0; x < width_; ++x) weight[x] = n[x] > half ? seen[x] : 0.0F;
    least_ = variance1_.min(variance2_);
    weight_ *= least_ / (least_ + static_cast<float>(options_.contrast));
  }

  /// Computes energy and loss of each window. Also computes `pull_`, the derivative of the loss
  /// with respect to the dissimilarity: 1 minus the correlation.
  void find_loss() {
    energy_ = weight_ * (1 - correlation_);
    loss_ = energy_;
    pull_ = weight_;
    if (options_.robust == 0) return;
    const auto scale = static_cast<float>(options_.robust);
    share_ = scale / (scale + (1 - correlation_).max(0.0F));
    loss_ *= share_;
    pull_ *= share_.square();
  }

  /// Compares the windows around the pixels of row `y` and adds their sums to `totals_`.
  void compare(int y) {
    find_moments(y);
    const auto noise = static_cast<float>(options_.noise_variance);
    inverse_ = sums_[count].max(1.0F).inverse();
    mean1_ = sums_[sum1] * inverse_;
    mean2_ = sums_[sum2] * inverse_;
    variance1_ = sums_[sum11] * inverse_ - mean1_.square() + noise;
    variance2_ = sums_[sum22] * inverse_ - mean2_.square() + noise;
    find_weights(y);

    deviations_ = (variance1_ * variance2_).sqrt();
    correlation_ = (sums_[sum12] * inverse_ - mean1_ * mean2_) / deviations_;
    find_loss();
    totals_.energy += energy_.template cast<double>().sum();
    totals_.loss += loss_.template cast<double>().sum();
    totals_.weight += weight_.template cast<double>().sum();
    totals_.pixels += static_cast<std::size_t>((weight_ > 0).count());
  }

  /// Stores factors for differentiating the losses of the windows around row `y`. The derivative of
  /// a window's loss with respect to the second intensity at a pixel is a linear function of both
  /// intensities at this pixel. The factors are its coefficients.
  void keep_factors(int y) {
    by_deviations_ = pull_ * inverse_ / deviations_;
    by_variance_ = pull_ * inverse_ / variance2_;
    factor(of_first, y) = -by_deviations_;
    factor(of_second, y) = by_variance_ * correlation_;
    factor(constant, y) = mean1_ * by_deviations_ - mean2_ * correlation_ * by_variance_;
    factor(of_square, y) = by_variance_;
  }

  Eigen::Map<Row> factor(Factor plane, int y) { return {factors_.row(plane, y), width_}; }

  void differentiate(int y) {
    for (std::size_t plane = 0; plane < factor_planes; ++plane) {
      const Rows in = reach(factors_, static_cast<int>(plane), y);
      sum_windows([&](std::size_t k, int x) { return in[k][x]; }, factor_sums_[plane]);
    }
    const auto row = [&](ComparedPlane plane) {
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
  Row column_;  ///< sums over the rows of a window, for each column; with zeros on both sides
  std::array<Row, moments> sums_;
  std::array<Row, factor_planes> factor_sums_;
  Row inverse_, mean1_, mean2_, variance1_, variance2_, deviations_, correlation_;
  Row least_, weight_, energy_, share_, loss_, pull_, by_deviations_, by_variance_;
  Row gradient_, curvature_;
  CorrelationSums totals_;
};

template <int radius>
CorrelationSums run(int width, int first_row, int end_row, const CorrelationOptions& options,
                    const std::function<void(int, const ComparedRow&)>& fill,
                    const std::function<void(int, const CorrelationRow&)>& take,
                    const std::function<void(int, const WindowRow&)>& look) {
  return Correlation<radius>(width, options).run(first_row, end_row, fill, take, look);
}

}  // namespace

CorrelationSums correlate(int width, int first_row, int end_row, const CorrelationOptions& options,
                          const std::function<void(int, const ComparedRow&)>& fill,
                          const std::function<void(int, const CorrelationRow&)>& take,
                          const std::function<void(int, const WindowRow&)>& look) {
  static constexpr std::array runs{run<1>, run<2>, run<3>, run<4>, run<5>};
  if (options.radius < 1 || options.radius > 5) throw UsageError("a window's radius is 1 to 5");
  if (!(options.noise_variance > 0)) throw UsageError("the variance of noise must be above 0");
  if (!(options.contrast >= 0)) throw UsageError("the contrast must be at least 0");
  if (options.robust != 0 && !(options.robust >= 1e-3 && options.robust <= 1e3))
    throw UsageError("the scale of a robust loss is 0, for none, or from 0.001 to 1000");
  if (width < 1 || first_row >= end_row) return {};
  return runs[static_cast<std::size_t>(options.radius - 1)](width, first_row, end_row, options,
                                                            fill, take, look);
}

}  // namespace transformesh
