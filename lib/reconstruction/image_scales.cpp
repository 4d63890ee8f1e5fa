#include "reconstruction/image_scales.h"

#include <algorithm>
#include <numbers>

#include "io/document/round_as_written.h"
#include "support/elementary/exponential.h"
#include "support/number.h"
#include "transformesh/measure.h"
#include "transformesh/mesh_io.h"
#include "transformesh/remesh.h"

namespace transformesh {
namespace {

// Width in pixels of photographs at the coarsest scale by default. Smaller photographs tolerate
// worse initial meshes but lose thin parts.
constexpr double coarsest_pixels = 28.5;
/// Factor that tolerates rounding: a scale or an edge this close to the requested one counts as
/// equal.
constexpr double tolerance = 0.999;

double scale_after(int steps) { return elementary::exp2(steps / 2.0); }

ScaleStep rounded(double scale, double edge) {
  return {read_back(fixed(scale, 4)), read_back(significant(edge, 9))};
}

}  // namespace

std::vector<ScaleStep> coarse_to_fine(const ScaleOptions& options, int image_width, double pixel) {
  const double coarsest =
      options.coarsest.value_or(std::min(image_width / coarsest_pixels, options.largest));
  int steps = 0;
  while (scale_after(steps) < coarsest * tolerance) ++steps;
  std::vector<ScaleStep> scale_steps;
  for (; steps >= 0; --steps)
    scale_steps.push_back(rounded(scale_after(steps), options.edge * scale_after(steps) * pixel));
  double edge = options.edge / std::numbers::sqrt2;
  while (edge > options.last_edge * tolerance) {
    scale_steps.push_back(rounded(1, edge * pixel));
    edge /= std::numbers::sqrt2;
  }
  return scale_steps;
}

double edge_times(double factor, double edge) { return read_back(significant(factor * edge, 9)); }

void remesh_to(Document& document, double edge, int iterations, const Progress& progress) {
  RemeshOptions options;
  options.iterations = iterations;
  options.min_edge = edge_times(0.7, edge);
  options.max_edge = edge_times(1.4, edge);
  options.coordinate = document.style.coordinate;
  remesh(document.mesh, options, progress);
  round_as_written(document);
}

void coarsen(Document& document, double edge, const Progress& progress) {
  double mean = edge_lengths(document.mesh).mean;
  while (2 * mean < edge) {
    mean = read_back(significant(2 * mean, 6));
    remesh_to(document, mean, 1, progress);
  }
}

}  // namespace transformesh
