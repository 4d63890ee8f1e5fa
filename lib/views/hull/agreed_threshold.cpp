#include "views/hull/agreed_threshold.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

#include "support/elementary/exponential.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/hull/hull_values.h"
#include "views/hull/silhouette.h"

namespace transformesh {
namespace {

// Resolution at which candidate thresholds are compared, chosen by hand. Time grows with the square
// of the image side and the cube of the hull resolution.
constexpr double largest_side_px = 320;  ///< largest side of shrunk photographs
constexpr int hull_resolution = 48;      ///< cells along the longest side of the box
/// Components of the hull with less than this fraction of the largest volume are dropped, because
/// they are hardly parts of the object.
constexpr double share_to_keep = 0.1;
/// Number of candidates below dividing_threshold(). Each candidate is the previous one divided by
/// 2^(1/4).
constexpr int steps_down = 8;
/// Candidate thresholds count as equally good if their agreement is at most this much below the
/// best.
constexpr double agreement_tolerance = 0.001;

struct SmallView {
  View view;
  double scale = 1;
};

std::vector<SmallView> small_photographs(std::span<const View> views) {
  std::vector<SmallView> result(views.size());
  parallel_for(views.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const GrayImage& image = views[i].image;
      if (image.empty()) continue;
      result[i].scale = std::max(1.0, std::max(image.width, image.height) / largest_side_px);
      // Do not call at_scale() for scale 1, because it blurs even photographs whose size does not
      // change.
      result[i].view = result[i].scale > 1 ? at_scale(views[i], result[i].scale) : views[i];
    }
  });
  std::erase_if(result, [](const SmallView& small) { return small.view.image.empty(); });
  return result;
}

std::vector<View> views_at(double intensity, const std::vector<SmallView>& small,
                           const ThresholdOptions& options) {
  std::vector<View> views(small.size());
  parallel_for(small.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      views[i] = small[i].view;
      views[i].silhouette = threshold_silhouette(
          views[i].image, {intensity, options.blur / small[i].scale, options.close});
    }
  });
  return views;
}

/// Returns the mean intersection over union of the views' silhouettes and the silhouettes of their
/// visual hull. Returns nothing if there is no hull.
std::optional<double> hull_agreement(const std::vector<View>& views) {
  Mesh hull;
  try {
    hull = visual_hull(views, {.resolution = hull_resolution, .keep = share_to_keep}).mesh;
  } catch (const InputError&) {
    return std::nullopt;
  }
  const std::vector<double> agreements = silhouette_agreements(hull, views);
  return std::accumulate(agreements.begin(), agreements.end(), 0.0) /
         static_cast<double>(agreements.size());
}

struct Candidate {
  double intensity = 0;
  double agreement = 0;
};

double highest_of_best(const std::vector<Candidate>& candidates) {
  double best = 0;
  for (const Candidate& candidate : candidates) best = std::max(best, candidate.agreement);
  double intensity = 0;
  for (const Candidate& candidate : candidates)
    if (candidate.agreement >= best - agreement_tolerance)
      intensity = std::max(intensity, candidate.intensity);
  return intensity;
}

}  // namespace

double agreed_threshold(std::span<const View> views, const ThresholdOptions& options,
                        const Progress& progress) {
  const std::vector<SmallView> small = small_photographs(views);
  if (small.empty()) throw UsageError("a threshold cannot be chosen without photographs");
  std::vector<GrayImage> images;
  images.reserve(small.size());
  for (const SmallView& view : small) images.push_back(view.view.image);
  const double dividing = dividing_threshold(images);

  std::vector<Candidate> candidates;
  for (int step = 0; step <= steps_down; ++step) {
    progress("level", static_cast<double>(step) / (steps_down + 1));
    const double intensity = dividing * elementary::exp2(-step / 4.0);
    const std::optional<double> agreement = hull_agreement(views_at(intensity, small, options));
    if (agreement) candidates.push_back({intensity, *agreement});
  }
  return candidates.empty() ? dividing : highest_of_best(candidates);
}

double threshold_silhouettes(std::vector<View>& views, ThresholdOptions options,
                             const Progress& progress) {
  if (!options.intensity) options.intensity = agreed_threshold(views, options, progress);
  for (View& view : views) {
    view.silhouette = threshold_silhouette(view.image, options);
    if (view.image.is_packed()) view.silhouette.pack();
  }
  return *options.intensity;
}

}  // namespace transformesh
