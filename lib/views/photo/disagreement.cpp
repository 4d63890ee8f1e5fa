#include "views/photo/disagreement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "support/parallel.h"
#include "transformesh/control.h"
#include "views/cameras/view.h"
#include "views/photo/photo_scene.h"
#include "views/photo/warp.h"

namespace transformesh {
namespace {

/// Ratio of the variance of noise to the squared median magnitude of its mixed second differences.
/// After the blur of scale 1 (at_scale()), the variance of independent noise is 0.1523 times that
/// of its mixed second differences. The median magnitude of a standard normal variable is 0.6745.
constexpr double variance_by_squared_median = 0.1523 / (0.6745 * 0.6745);

/// Upper limit of the dissimilarity that noise explains (the floor) in WindowSums::excess(). If
/// noise explains more, the photographs hardly have a common signal, and the excess would be the
/// quotient of two small numbers.
constexpr double largest_floor = 0.9;

struct Window {
  float weight = 0, energy = 0, floor = 0;
  float excess() const { return (energy - floor) / weight; }
};

/// Stores the two best windows of each pixel, over all pairs with the same reference view. Pixels
/// are those of VisibleSurface::compared.
class BestWindows {
 public:
  /// Clears all windows, for a rectangle of this size; keeps the allocated memory.
  void begin(int width, int height) {
    width_ = width;
    windows_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), {});
  }
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
  int width_ = 0;
  std::vector<Ranked> windows_;
};

bool is_inside_depth(const GrayImage& depth, int x, int y) {
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      if (!(depth.at(x + j, y + i) > 0)) return false;
  return true;
}

void add_windows_of_pair(const Warp& warp, const VisibleSurface& seen, double noise,
                         const PhotoconsistencyOptions& options, BestWindows& best) {
  const auto excess = static_cast<float>(options.correlation.noise_variance + noise);
  correlate(
      best.width(), seen.compared.first_row, seen.compared.end_row, options.correlation,
      [&](int y, const ComparedRow& row) {
        warp.row(y, options.interpolation, {row.is_seen, row.first, row.second, row.slope});
      },
      {},
      [&](int y, const WindowRow& row) {
        for (int x = 0; x < best.width(); ++x) {
          const float floor = row.weight[x] * std::min(excess / row.deviations[x], 1.0F);
          best.add(x, y - seen.compared.first_row, {row.weight[x], row.energy[x], floor});
        }
      });
}

/// Result of comparing one reference view with its partner views. Also holds buffers that are
/// reused for the next reference view.
struct ComparedView {
  VisibleSurface room;
  WarpRoom warp_room;
  const VisibleSurface* seen = nullptr;
  BestWindows best;
};

void compare_windows_with_others(std::size_t reference, const PhotoScene& scene,
                                 const SeenViews& seen, std::span<const double> noise,
                                 const PhotoconsistencyOptions& options, ComparedView& result) {
  const VisibleSurface& from = seen.surface(reference, result.room);
  result.seen = &from;
  result.best.begin(std::max(from.compared.columns(), 0), std::max(from.compared.rows(), 0));
  if (from.compared.rows() <= 0) return;
  for (const ViewPair& pair : scene.pairs) {
    if (pair.first != reference) continue;
    const Warp warp(scene.views[reference], from, scene.views[pair.second],
                    seen.depths(pair.second), options.depth_tolerance, result.warp_room);
    add_windows_of_pair(warp, from, (noise[reference] + noise[pair.second]) / 2, options,
                        result.best);
  }
}

void add_windows_to_vertices(const Mesh& mesh, const ComparedView& view, Disagreement& result) {
  const VisibleSurface& seen = *view.seen;
  const PixelBox& box = seen.compared;
  for (int y = box.first_row; y < box.end_row; ++y) {
    for (int x = box.first_column; x < box.end_column; ++x) {
      const Window window = view.best.at(x - box.first_column, y - box.first_row);
      if (window.weight == 0) continue;
      result.all += {window.weight, window.energy, window.floor};
      const FacePixel& pixel = seen.faces.at(x - seen.box.first_column, y - seen.box.first_row);
      const std::array<double, 3> share{pixel.weight[0], pixel.weight[1],
                                        1.0 - pixel.weight[0] - pixel.weight[1]};
      for (std::size_t i = 0; i < 3; ++i)
        result.of_vertex[mesh.faces[pixel.face][i]] +=
            {share[i] * window.weight, share[i] * window.energy, share[i] * window.floor};
    }
  }
}

/// Returns the variance of the noise in each photograph, from the pixels that show the surface.
std::vector<double> noise_variances(std::span<const View> views, const SeenViews& seen) {
  std::vector<double> noise(views.size());
  parallel_for(views.size(), 1, [&](std::size_t first, std::size_t last) {
    VisibleSurface room;
    for (std::size_t v = first; v < last; ++v) {
      const VisibleSurface& surface = seen.surface(v, room);
      const PixelBox& box = surface.box;
      GrayImage part;
      if (surface.intensity.empty())
        views[v].image.unpack_rectangle(box.first_column, box.first_row, box.columns(), box.rows(),
                                        part);
      noise[v] =
          noise_variance(surface.intensity.empty() ? part : surface.intensity, surface.depth);
    }
  });
  return noise;
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
      if (!is_inside_depth(depth, x, y)) continue;
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
  const std::vector<double> noise = noise_variances(scene.views, seen);

  // Sums are added in the order of the views, so that the result does not depend on the threads.
  Disagreement result;
  result.of_vertex.resize(mesh.positions.size());
  // To save memory, at most one view per thread is compared at the same time.
  std::vector<ComparedView> compared(std::min(allowed_thread_count(), count));
  for (std::size_t begin = 0; begin < count; begin += compared.size()) {
    const std::size_t end = std::min(compared.size(), count - begin);
    parallel_for(end, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        compare_windows_with_others(begin + i, scene, seen, noise, options, compared[i]);
    });
    for (std::size_t i = 0; i < end; ++i) add_windows_to_vertices(mesh, compared[i], result);
  }
  return result;
}

}  // namespace transformesh
