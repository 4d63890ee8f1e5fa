#include "views/photo/correlation.h"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "helpers/random.h"
#include "transformesh/errors.h"

using namespace transformesh;
using doctest::Approx;

namespace {

constexpr int width = 23;
constexpr int height = 19;

/// Two images with a hole in the mask, with intensities relative to the middle one.
struct Images {
  std::vector<float> is_seen, first, second, slope;

  Images() {
    test::Random random(8);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const bool hidden = (x > 9 && x < 13 && y > 5) || (x + y) % 11 == 0;
        is_seen.push_back(hidden ? 0 : 1);
        const double intensity = 40 * std::sin(0.5 * x + 0.3 * y) + random.uniform(-8, 8);
        first.push_back(hidden ? 0 : static_cast<float>(intensity));
        second.push_back(hidden ? 0 : static_cast<float>(0.7 * intensity + random.uniform(-9, 9)));
        slope.push_back(hidden ? 0 : static_cast<float>(random.uniform(-3, 3)));
      }
    }
  }
};

/// Computes the energy in doubles, window by window, by its definition. rho may be given.
struct Direct {
  double energy = 0;
  double loss = 0;
  double weight = 0;
  std::size_t pixels = 0;
  std::vector<double> rho;
};
Direct direct(const Images& images, const CorrelationOptions& options,
              const std::vector<double>& second, const std::vector<double>* rho = nullptr) {
  Direct result;
  result.rho.assign(images.first.size(), 0);
  const int r = options.radius;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double n = 0, s1 = 0, s2 = 0, s11 = 0, s22 = 0, s12 = 0;
      for (int j = std::max(y - r, 0); j <= std::min(y + r, height - 1); ++j) {
        for (int i = std::max(x - r, 0); i <= std::min(x + r, width - 1); ++i) {
          const auto at = static_cast<std::size_t>(j * width + i);
          if (images.is_seen[at] == 0) continue;
          const double a = images.first[at];
          const double b = second[at];
          n += 1, s1 += a, s2 += b, s11 += a * a, s22 += b * b, s12 += a * b;
        }
      }
      const auto at = static_cast<std::size_t>(y * width + x);
      if (images.is_seen[at] == 0 || n <= 0.5 * (2 * r + 1) * (2 * r + 1)) continue;
      const double v1 = s11 / n - s1 * s1 / (n * n) + options.noise_variance;
      const double v2 = s22 / n - s2 * s2 / (n * n) + options.noise_variance;
      const double cc = (s12 / n - s1 * s2 / (n * n)) / std::sqrt(v1 * v2);
      const double least = std::min(v1, v2);
      result.rho[at] = rho ? (*rho)[at] : least / (least + options.contrast);
      const double e = 1 - cc;
      result.energy += result.rho[at] * e;
      result.loss += result.rho[at] * (options.robust > 0 ? 1 / (1 / e + 1 / options.robust) : e);
      result.weight += result.rho[at];
      ++result.pixels;
    }
  }
  return result;
}

struct Found {
  CorrelationSums sums;
  std::vector<float> gradient, curvature, is_seen;
};
Found correlate_images(const Images& images, const CorrelationOptions& options, int first_row = 0) {
  Found found;
  const auto fill = [&](int y, const ComparedRow& row) {
    const auto start = static_cast<std::ptrdiff_t>((y - first_row) * width);
    std::copy_n(images.is_seen.begin() + start, width, row.is_seen);
    std::copy_n(images.first.begin() + start, width, row.first);
    std::copy_n(images.second.begin() + start, width, row.second);
    std::copy_n(images.slope.begin() + start, width, row.slope);
  };
  int next = first_row;
  const auto take = [&](int y, const CorrelationRow& row) {
    CHECK(y == next++);
    found.gradient.insert(found.gradient.end(), row.gradient, row.gradient + width);
    found.curvature.insert(found.curvature.end(), row.curvature, row.curvature + width);
    found.is_seen.insert(found.is_seen.end(), row.is_seen, row.is_seen + width);
  };
  found.sums = correlate(width, first_row, first_row + height, options, fill, take);
  CHECK(next == first_row + height);
  return found;
}

}  // namespace

TEST_CASE("sums are those of the definition, for every radius, mask and first row") {
  const Images images;
  const std::vector<double> second(images.second.begin(), images.second.end());
  for (int radius = 1; radius <= 5; ++radius) {
    for (const double contrast : {0.0, 25.0}) {
      const CorrelationOptions options{radius, 25, contrast, radius == 4 ? 0 : 0.1 * radius};
      const Direct expected = direct(images, options, second);
      for (const int first_row : {0, 7}) {
        const CorrelationSums sums = correlate_images(images, options, first_row).sums;
        CHECK(sums.pixels == expected.pixels);
        CHECK(sums.energy == Approx(expected.energy).epsilon(1e-5));
        CHECK(sums.loss == Approx(expected.loss).epsilon(1e-5));
        CHECK(sums.weight == Approx(expected.weight).epsilon(1e-5));
      }
    }
  }
}

TEST_CASE("the derivative by every pixel is that of the definition") {
  const Images images;
  for (const auto& [radius, robust] :
       {std::pair{1, 0.0}, {3, 0.0}, {5, 0.0}, {2, 0.5}, {3, 0.1}, {5, 0.02}}) {
    const CorrelationOptions options{radius, 25, 25, robust};
    const Found found = correlate_images(images, options);
    std::vector<double> second(images.second.begin(), images.second.end());
    const std::vector<double> rho = direct(images, options, second).rho;
    CHECK(found.is_seen == images.is_seen);
    for (std::size_t i = 0; i < second.size(); ++i) {
      const double intensity = second[i];
      second[i] = intensity + 1e-3;
      const double above = direct(images, options, second, &rho).loss;
      second[i] = intensity - 1e-3;
      const double below = direct(images, options, second, &rho).loss;
      second[i] = intensity;
      const double expected = (above - below) / 2e-3 * images.slope[i];
      CHECK(std::abs(found.gradient[i] - expected) < 1e-5 * (1 + 10 * std::abs(expected)));
      CHECK(found.curvature[i] >= 0);
    }
  }
}

TEST_CASE("a robust loss does not change the measure, and weakens outliers") {
  Images images;
  const CorrelationSums plain = correlate_images(images, {3, 25, 25}).sums;
  const CorrelationSums robust = correlate_images(images, {3, 25, 25, 0.1}).sums;
  CHECK(robust.energy == plain.energy);
  CHECK(robust.weight == plain.weight);
  CHECK(plain.loss == plain.energy);
  CHECK(correlate_images(images, {3, 25, 25, 1000}).sums.loss == Approx(plain.loss).epsilon(1e-3));
  // The cost of a window is at most s.
  for (float& intensity : images.second) intensity = -intensity;
  const CorrelationSums against = correlate_images(images, {3, 25, 25, 0.1}).sums;
  CHECK(against.energy > 1.5 * against.weight);
  CHECK(against.loss < 0.1 * against.weight);
}

TEST_CASE("gains and offsets of an image change little, and textureless windows weigh little") {
  Images images;
  const CorrelationOptions options{3, 1e-3, 25};
  const double energy = correlate_images(images, options).sums.energy;
  for (std::size_t i = 0; i < images.second.size(); ++i) {
    if (images.is_seen[i] != 0) images.second[i] = 1.25F * images.second[i] + 12;
  }
  CHECK(correlate_images(images, options).sums.energy == Approx(energy).epsilon(0.04));
  for (std::size_t i = 0; i < images.first.size(); ++i) images.first[i] = images.is_seen[i] * 3;
  CHECK(correlate_images(images, options).sums.weight < 1e-3 * width * height);
}

TEST_CASE("options out of range are refused") {
  const Images images;
  CHECK_THROWS_AS(correlate_images(images, {0, 25, 25}), UsageError);
  CHECK_THROWS_AS(correlate_images(images, {6, 25, 25}), UsageError);
  CHECK_THROWS_AS(correlate_images(images, {3, 0, 25}), UsageError);
  CHECK_THROWS_AS(correlate_images(images, {3, 25, -1}), UsageError);
  for (const double robust : {-0.1, 1e-4, 1e4, std::nan("")})
    CHECK_THROWS_AS(correlate_images(images, {3, 25, 25, robust}), UsageError);
}
