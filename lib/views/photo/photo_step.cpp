#include "transformesh/photo_step.h"

#include <algorithm>
#include <cmath>

#include "mesh/local_measures.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "views/photo/contour_gaps.h"
#include "views/photo/photo_scene.h"
#include "views/photo/photoconsistency.h"
#include "views/photo/scene_step.h"
#include "views/photo/thin_plate.h"

namespace transformesh {
namespace {

void check_step_options(const PhotoStepOptions& options) {
  const auto check_least = [](double value, const char* name) {
    if (!(value >= 0 && std::isfinite(value)))
      throw UsageError(std::string(name) + " must be at least 0");
  };
  check_least(options.stiffness, "the stiffness");
  check_least(options.damping, "the damping");
  check_least(options.time_step, "the time step");
  check_least(options.silhouettes, "the pull of silhouettes");
  check_least(options.least_cosine, "the least cosine");
  if (!(options.smoothing >= 0 && options.smoothing <= 1))
    throw UsageError("the smoothing must be from 0 to 1");
}

std::vector<ViewPair> compared_pairs(const std::vector<ViewPair>& pairs, PairOrder order) {
  if (order == PairOrder::both) return pairs;
  std::vector<ViewPair> result;
  for (const ViewPair& pair : pairs)
    if ((pair.first < pair.second) == (order == PairOrder::rising)) result.push_back(pair);
  return result;
}

/// Returns the second derivative (curvature) of the photometric energy at each vertex, plus a
/// damping term. If `damping` > 0, the sum is positive at all vertices that at least one pair of
/// views compares.
std::vector<double> damped_curvature(const Photoconsistency& measured, double damping) {
  std::vector<double> result(measured.curvature);
  for (std::size_t v = 0; v < result.size(); ++v) result[v] += damping * measured.coverage[v];
  return result;
}

/// Returns the median of `curvature` over the vertices that at least one pair of views compares.
/// There must be at least one such vertex.
double usual_curvature(const Photoconsistency& measured, std::span<const double> curvature) {
  std::vector<double> seen;
  for (std::size_t v = 0; v < curvature.size(); ++v) {
    if (measured.coverage[v] > 0) seen.push_back(curvature[v]);
  }
  const auto middle = seen.begin() + static_cast<std::ptrdiff_t>(seen.size() / 2);
  std::nth_element(seen.begin(), middle, seen.end());
  return *middle;
}

std::vector<double> newton_movements(const Mesh& mesh, const UniformLaplacian& laplacian,
                                     std::vector<Vec3> normals, const Photoconsistency& measured,
                                     const ContourGaps& gaps, double pixel,
                                     const PhotoStepOptions& options) {
  ThinPlateProblem problem;
  problem.normals = std::move(normals);
  problem.gradient.resize(mesh.positions.size());
  problem.curvature = damped_curvature(measured, options.damping / (pixel * pixel));
  const double usual = usual_curvature(measured, problem.curvature);
  const double pull = options.silhouettes * usual;
  problem.stiffness = options.stiffness * usual;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const bool is_outside = gaps.outside[v] > 0;
    problem.gradient[v] =
        measured.gradient[v].dot(problem.normals[v]) + pull * (gaps.outside[v] - gaps.inside[v]);
    problem.curvature[v] += pull * ((is_outside ? 1 : 0) + gaps.rims[v]);
  }
  return thin_plate_step(mesh, laplacian, problem);
}

std::vector<double> gradient_movements(const Mesh& mesh, std::span<const Vec3> normals,
                                       const Photoconsistency& measured, const ContourGaps& gaps,
                                       const PhotoStepOptions& options) {
  const std::vector<double> areas = vertex_areas(mesh);
  std::vector<double> movements(areas.size(), 0);
  for (std::size_t v = 0; v < movements.size(); ++v) {
    if (areas[v] > 0)
      movements[v] = -options.time_step * measured.gradient[v].dot(normals[v]) / areas[v];
    movements[v] -= options.silhouettes * (gaps.outside[v] - gaps.inside[v]);
  }
  return movements;
}

double mean_edge(const Mesh& mesh, const UniformLaplacian& laplacian, Index vertex) {
  const std::span<const Index> around = laplacian.neighbors(vertex);
  double sum = 0;
  for (const Index neighbor : around)
    sum += (mesh.positions[neighbor] - mesh.positions[vertex]).norm();
  return around.empty() ? 0 : sum / static_cast<double>(around.size());
}

/// Returns the mean over all vertices of movement / mean edge length at the vertex before the
/// movement.
double mean_share(const Mesh& before, const Mesh& after, const UniformLaplacian& laplacian) {
  double sum = 0;
  std::size_t count = 0;
  for (Index v = 0; v < before.positions.size(); ++v) {
    const double edge = mean_edge(before, laplacian, v);
    if (!(edge > 0)) continue;
    sum += (after.positions[v] - before.positions[v]).norm() / edge;
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

void smooth(Mesh& mesh, const UniformLaplacian& laplacian, double factor) {
  std::vector<Vec3> ways;
  laplacian.apply(mesh.positions, ways);
  for (std::size_t v = 0; v < ways.size(); ++v) mesh.positions[v] += factor * ways[v];
}

/// Returns unit normals of vertices; zero at border vertices, so that these do not move. Windows at
/// a border contain little of the surface, and movements of border vertices would tear the surface.
std::vector<Vec3> normals_off_borders(const Mesh& mesh, const UniformLaplacian& laplacian) {
  std::vector<Vec3> normals = vertex_normals(mesh);
  for (Index v = 0; v < normals.size(); ++v)
    if (laplacian.is_border(v)) normals[v] = Vec3::Zero();
  return normals;
}

}  // namespace

PhotoStepResult photo_step(Mesh& mesh, const PhotoScene& scene, const PhotoStepOptions& options,
                           const Progress& progress) {
  check_step_options(options);
  progress("see");
  const SeenViews seen(mesh, scene.views, options.least_cosine);
  const Photoconsistency measured =
      photoconsistency(mesh, scene.views, seen, compared_pairs(scene.pairs, options.order),
                       options.photographs, progress);
  if (measured.pixels == 0) throw InputError("no part of the mesh is visible in two views");
  progress("move");
  const ContourGaps gaps = contour_gaps(mesh, scene.views, seen, scene.distances, options.meaning);

  // Vertices move along their normals. displace() clamps the movements.
  const UniformLaplacian laplacian(mesh);
  const std::vector<Vec3> normals = normals_off_borders(mesh, laplacian);
  const bool is_gradient = options.rule == PhotoStepRule::gradient;
  const std::vector<double> movements =
      is_gradient
          ? gradient_movements(mesh, normals, measured, gaps, options)
          : newton_movements(mesh, laplacian, normals, measured, gaps, scene.pixel, options);
  std::vector<Vec3> ways(normals.size());
  for (std::size_t v = 0; v < ways.size(); ++v) ways[v] = movements[v] * normals[v];
  const Mesh before{mesh.positions, {}, {}, {}};
  PhotoStepResult result;
  result.displaced = displace(mesh, ways, {1, options.alpha});
  result.mean_share = mean_share(before, mesh, laplacian);
  if (is_gradient) smooth(mesh, laplacian, options.smoothing);

  result.energy = measured.energy;
  result.dissimilarity = measured.weight > 0 ? measured.energy / measured.weight : 0;
  result.pixels = measured.pixels;
  result.coverage = static_cast<double>(measured.pixels) / static_cast<double>(measured.visible);
  result.unseen =
      static_cast<std::size_t>(std::count(measured.coverage.begin(), measured.coverage.end(), 0.0));
  result.outside = static_cast<std::size_t>(
      std::count_if(gaps.outside.begin(), gaps.outside.end(),
                    [&](double outside) { return outside > scene.pixel; }));
  return result;
}

PhotoStepResult photo_step(Mesh& mesh, const Views& views, double scale,
                           const PhotoStepOptions& options, const PairOptions& pairs,
                           const Progress& progress) {
  return photo_step(mesh, photo_scene(views.list(), scale, pairs), options, progress);
}

}  // namespace transformesh
