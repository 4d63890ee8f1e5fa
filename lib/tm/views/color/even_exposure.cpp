#include "tm/views/color/even_exposure.h"

#include <algorithm>
#include <map>

namespace transformesh {
namespace {

constexpr double level_variance = 100;
constexpr float least_level = 8, largest_level = 247;
constexpr float most_different = 1.5F;  ///< times the other level
constexpr int sweeps = 200;
constexpr double enough = 1e-4;  ///< change of a gain in a sweep
constexpr double most_gain = 4;

/// Sums of levels over the places that two views see.
struct Overlap {
  double first = 0, second = 0;
  double count = 0;
};

using ViewPairKey = std::pair<std::size_t, std::size_t>;
using Overlaps = std::map<ViewPairKey, Overlap>;

bool is_comparable(float a, float b) {
  return std::min(a, b) >= least_level && std::max(a, b) <= largest_level &&
         std::max(a, b) <= most_different * std::min(a, b);
}

Overlaps overlaps_of(std::span<const Glimpses> seen, int channel) {
  Overlaps overlaps;
  for (const Glimpses& glimpses : seen) {
    const std::size_t count = glimpses.count_good();
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j) {
        const float a = glimpses.levels(i)[channel];
        const float b = glimpses.levels(j)[channel];
        if (!is_comparable(a, b)) continue;
        Overlap& overlap = overlaps[{glimpses.view(i), glimpses.view(j)}];
        overlap.first += a;
        overlap.second += b;
        ++overlap.count;
      }
    }
  }
  return overlaps;
}

/// The equations of a view: diagonal * gain = prior + sum of factors * other gains.
struct Equation {
  double diagonal = 0, prior = 0;
  std::vector<std::pair<std::size_t, double>> others;

  void add(double sum, double sum_of_other, double count, std::size_t other) {
    const double mean = sum / count;
    diagonal += mean * sum / level_variance + count;
    prior += count;
    others.emplace_back(other, mean * sum_of_other / level_variance);
  }
};

/// By Gauss and Seidel: the matrix is symmetric and positive definite.
std::vector<double> solved(std::span<const Equation> equations) {
  std::vector<double> gains(equations.size(), 1);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double change = 0;
    for (std::size_t i = 0; i < gains.size(); ++i) {
      const Equation& equation = equations[i];
      if (equation.diagonal == 0) continue;
      double sum = equation.prior;
      for (const auto& [other, factor] : equation.others) sum += factor * gains[other];
      const double gain = std::clamp(sum / equation.diagonal, 1 / most_gain, most_gain);
      change = std::max(change, std::abs(gain - gains[i]));
      gains[i] = gain;
    }
    if (change < enough) break;
  }
  return gains;
}

}  // namespace

std::vector<Gain> even_exposure(std::span<const Glimpses> seen, std::size_t views) {
  std::vector<Gain> gains(views, Gain::Ones());
  for (int channel = 0; channel < 3; ++channel) {
    std::vector<Equation> equations(views);
    for (const auto& [pair, overlap] : overlaps_of(seen, channel)) {
      const auto& [first, second] = pair;
      equations[first].add(overlap.first, overlap.second, overlap.count, second);
      equations[second].add(overlap.second, overlap.first, overlap.count, first);
    }
    const std::vector<double> found = solved(equations);
    for (std::size_t i = 0; i < views; ++i) gains[i][channel] = static_cast<float>(found[i]);
  }
  return gains;
}

double largest_gain(std::span<const Gain> gains) {
  float largest = 1;
  for (const Gain& gain : gains)
    largest = std::max({largest, gain.maxCoeff(), gain.inverse().maxCoeff()});
  return largest;
}

}  // namespace transformesh
