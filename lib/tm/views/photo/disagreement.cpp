#include "tm/views/photo/disagreement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "tm/support/parallel.h"
#include "tm/views/photo/warp.h"

namespace transformesh {
namespace {

/// Of independent noise after the blur of scale 1, the variance by that of its mixed second
/// difference, both over the median of a normal deviate's magnitude.
constexpr double variance_by_squared_median = 0.1523 / (0.6745 * 0.6745);

/// Above it hardly anything is left that photographs could have in common, and excess says little.
constexpr double largest_floor = 0.9;
/// Views whose pixels are held at a time.
constexpr std::size_t views_at_once = 8;

struct Window {
  float weight = 0, energy = 0, floor = 0;
  float excess() const { return (energy - floor) / weight; }
};

/// Of the pairs with the same reference view the two that agree best, for each pixel of its box.
class BestWindows {
 public:
  BestWindows(int width, int height)
      : width_(width),
        windows_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  int width() const { return width_; }
  void add(int x, int y, const Window& window) {
    if (!(window.weight > 0)) return;
    Ranked& at = windows_[index(x, y)];
    if (at.count == 0 || window.excess() < at.best.excess()) {
      at.second = at.best;
      at.best = window;
    } else if (at.count == 1 || window.excess() < at.second.excess()) {
      at.second = window;
    }
    ++at.count;
  }
  Window at(int x, int y) const {
    const Ranked& at = windows_[index(x, y)];
    return at.count > 2 ? at.second : at.best;
  }

 private:
  struct Ranked {
    Window best, second;
    std::uint32_t count = 0;
  };
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }
  int width_;
  std::vector<Ranked> windows_;
};

bool is_inside(const GrayImage& depth, int x, int y) {
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      if (!(depth.at(x + j, y + i) > 0)) return false;
  return true;
}

void add_pair(const Warp& warp, const SeenSurface& seen, double noise,
              const PhotoconsistencyOptions& options, BestWindows& best) {
  const auto excess = static_cast<float>(options.correlation.noise_variance + noise);
  correlate(
      best.width(), seen.first_row, seen.end_row, options.correlation,
      [&](int y, const ComparedRow& row) {
        warp.row(y, options.interpolation, {row.is_seen, row.first, row.second, row.slope});
      },
      {},
      [&](int y, const WindowRow& row) {
        for (int x = 0; x < best.width(); ++x) {
          const float floor = row.weight[x] * std::min(excess / row.deviations[x], 1.0F);
          best.add(x, y - seen.first_row, {row.weight[x], row.energy[x], floor});
        }
      });
}

BestWindows compare_with_others(std::size_t reference, const PhotoScene& scene,
                                const SeenViews& seen, std::span<const double> noise,
                                const PhotoconsistencyOptions& options) {
  SeenSurface room;
  const SeenSurface& from = seen.surface(reference, room);
  if (from.first_row >= from.end_row) return {0, 0};
  BestWindows best(from.end_column - from.first_column, from.end_row - from.first_row);
  for (const ViewPair& pair : scene.pairs) {
    if (pair.first != reference) continue;
    const Warp warp(scene.views[reference], from, scene.views[pair.second],
                    seen.depths(pair.second), options.depth_tolerance);
    add_pair(warp, from, (noise[reference] + noise[pair.second]) / 2, options, best);
  }
  return best;
}

void add_to_vertices(const Mesh& mesh, const BestWindows& best, const SeenSurface& seen,
                     Disagreement& result) {
  for (int y = seen.first_row; y < seen.end_row; ++y) {
    for (int x = seen.first_column; x < seen.end_column; ++x) {
      const Window window = best.at(x - seen.first_column, y - seen.first_row);
      if (window.weight == 0) continue;
      result.all += {window.weight, window.energy, window.floor};
      const FacePixel& pixel = seen.faces.at(x, y);
      const std::array<double, 3> share{pixel.weight[0], pixel.weight[1],
                                        1.0 - pixel.weight[0] - pixel.weight[1]};
      for (std::size_t i = 0; i < 3; ++i)
        result.of_vertex[mesh.faces[pixel.face][i]] +=
            {share[i] * window.weight, share[i] * window.energy, share[i] * window.floor};
    }
  }
}

}  // namespace

WindowSums& WindowSums::operator+=(const WindowSums& other) {
  weight += other.weight;
  energy += other.energy;
  floor += other.floor;
  return *this;
}

double WindowSums::excess() const {
  const double explained = mean_floor();
  const double rest = 1 - std::min(explained, largest_floor);
  return std::clamp((dissimilarity() - explained) / rest, 0.0, 1.0);
}

double noise_variance(const GrayImage& image, const GrayImage& depth) {
  std::vector<float> differences;
  for (int y = 1; y + 1 < image.height; ++y) {
    for (int x = 1; x + 1 < image.width; ++x) {
      if (!is_inside(depth, x, y)) continue;
      const auto second = [&](int row) {
        return image.at(x - 1, row) - 2 * image.at(x, row) + image.at(x + 1, row);
      };
      differences.push_back(std::abs(second(y - 1) - 2 * second(y) + second(y + 1)));
    }
  }
  if (differences.empty()) return 0;
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  return variance_by_squared_median * *middle * *middle;
}

Disagreement disagreement(const Mesh& mesh, const PhotoScene& scene, double least_cosine,
                          const PhotoconsistencyOptions& options, const Progress& progress) {
  progress("look for disagreement");
  const SeenViews seen(mesh, scene.views, least_cosine);
  const std::size_t count = scene.views.size();
  std::vector<double> noise(count);
  parallel_for(count, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      SeenSurface room;
      noise[v] = noise_variance(scene.views[v].image, seen.surface(v, room).depth);
    }
  });

  // Sums go by the order of the views, for the same bytes with any number of threads.
  Disagreement result;
  result.of_vertex.resize(mesh.positions.size());
  for (std::size_t begin = 0; begin < count; begin += views_at_once) {
    std::vector<BestWindows> best(std::min(views_at_once, count - begin), BestWindows(0, 0));
    parallel_for(best.size(), 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        best[i] = compare_with_others(begin + i, scene, seen, noise, options);
    });
    SeenSurface room;
    for (std::size_t i = 0; i < best.size(); ++i)
      add_to_vertices(mesh, best[i], seen.surface(begin + i, room), result);
  }
  return result;
}

}  // namespace transformesh
