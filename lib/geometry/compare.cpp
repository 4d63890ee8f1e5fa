// Compares two surfaces: measures the distances of sample points and vertices of each surface from
// the other surface. Cost: O((n + samples) log n) on usual meshes. Floating point; deterministic
// for any number of threads.
#include "transformesh/compare.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "geometry/common_extent.h"
#include "geometry/search/closest_point.h"
#include "geometry/search/kd_tree.h"
#include "geometry/surface_samples.h"
#include "mesh/local_measures.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// The reported accuracy is the distance below which this fraction of the samples is.
constexpr double accuracy_share = 0.9;
/// Default of CompareOptions::distance, as a fraction of the bounding box diagonal of the
/// reference.
constexpr double default_distance_share = 0.01;
constexpr std::size_t points_per_task = 256;  ///< affects time only
/// Number of points between two reports of progress.
constexpr std::size_t points_per_report = 16384;
/// Every 61st point is tested before the other points, to find a large distance early. A choice
/// that affects only the time.
constexpr std::size_t vanguard = 61;
/// A factor slightly below 1. The difference from 1 exceeds the relative rounding error of a
/// distance.
constexpr double certainly = 1 - 1e-12;

/// Distance of a point to the faces of a mesh, or to its vertices if it has no faces.
class Distance {
 public:
  explicit Distance(const Mesh& mesh) : mesh_(mesh) {
    if (mesh.faces.empty()) {
      vertices_.emplace(mesh.positions);
    } else {
      surface_.emplace(mesh);
    }
  }
  double operator()(const Vec3& point) const {
    if (surface_) return (*surface_)(point).distance;
    return (mesh_.positions[vertices_->nearest(point)] - point).norm();
  }

 private:
  const Mesh& mesh_;
  std::optional<KdTree> vertices_;
  std::optional<ClosestPointQuery> surface_;
};

std::vector<double> distances(const std::vector<Vec3>& points, const auto& distance,
                              const Progress& progress, const char* phase) {
  std::vector<double> result(points.size());
  for (std::size_t begin = 0; begin < points.size(); begin += points_per_report) {
    progress(phase, static_cast<double>(begin) / static_cast<double>(points.size()));
    const std::size_t count = std::min(points_per_report, points.size() - begin);
    parallel_for(count, points_per_task, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = begin + first; i < begin + last; ++i) result[i] = distance(points[i]);
    });
  }
  return result;
}

/// Returns the vertices that faces use, or all vertices if there are no faces.
std::vector<Vec3> used_vertices(const Mesh& mesh) {
  return mesh.faces.empty() ? mesh.positions : used_positions(mesh);
}

/// Distances from one mesh to the other. `by_area` has the distances of samples, or of vertices if
/// there are no samples.
struct OneWay {
  std::vector<double> by_area;
  double largest = 0;
  double mean = 0;
  double mean_square = 0;
};

OneWay measure(const Mesh& from, const Mesh& to, const CompareOptions& options,
               const Progress& progress, const char* phase) {
  progress(phase);
  const Distance distance(to);
  OneWay result;
  result.by_area =
      distances(surface_samples(from, options.samples, options.seed), distance, progress, phase);
  const std::vector<double> at_vertices = distances(used_vertices(from), distance, progress, phase);
  if (result.by_area.empty()) result.by_area = at_vertices;

  for (const double d : at_vertices) result.largest = std::max(result.largest, d);
  for (const double d : result.by_area) {
    result.largest = std::max(result.largest, d);
    result.mean += d;
    result.mean_square += d * d;
  }
  const auto count = static_cast<double>(result.by_area.size());
  result.mean /= count;
  result.mean_square /= count;
  return result;
}

void check_comparable(const Mesh& mesh, const Mesh& reference) {
  if (mesh.positions.empty()) throw InputError("the mesh has no vertices: nothing to compare");
  if (reference.positions.empty())
    throw InputError("the reference has no vertices: nothing to compare with");
  check_common_extent(mesh, reference, "to compare");
}

/// Returns the smallest value v such that at least the fraction `share` of the values is at most v.
double quantile(std::vector<double> values, double share) {
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  const auto nth = values.begin() + (static_cast<std::ptrdiff_t>(rank) - 1);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

double share_within(const std::vector<double>& values, double distance) {
  const auto count =
      std::count_if(values.begin(), values.end(), [&](double value) { return value <= distance; });
  return static_cast<double>(count) / static_cast<double>(values.size());
}

/// Returns all numbers below `count`, starting with every 61st of them.
std::vector<std::size_t> vanguard_first(std::size_t count) {
  std::vector<std::size_t> order;
  order.reserve(count);
  for (std::size_t i = 0; i < count; i += vanguard) order.push_back(i);
  for (std::size_t i = 0; i < count; ++i)
    if (i % vanguard != 0) order.push_back(i);
  return order;
}

/// Returns the distances of the points from the mesh, or 0 for points that are certainly closer
/// than `least`. The search for a point starts at the face that was found for the previous point.
std::vector<double> distances_beyond(std::span<const Vec3> points,
                                     std::span<const std::size_t> numbers,
                                     const ClosestPointQuery& closest, double least) {
  std::vector<double> beyond(numbers.size(), 0);
  const auto take_run = [&](std::size_t run) {
    Index hint = no_index;
    const std::size_t end = std::min((run + 1) * points_per_task, numbers.size());
    for (std::size_t i = run * points_per_task; i < end; ++i) {
      const Vec3& point = points[numbers[i]];
      const Index near = closest.face_within(point, certainly * least, hint);
      if (near != no_index) {
        hint = near;
        continue;
      }
      const ClosestPoint found = closest(point, hint);
      beyond[i] = found.distance;
      hint = found.face;
    }
  };
  // Points are processed in runs of consecutive points. The search for a point starts at the face
  // found for the previous point of its run. The length of runs does not depend on the number of
  // threads, and neither do the results.
  const std::size_t runs = (numbers.size() + points_per_task - 1) / points_per_task;
  parallel_for(runs, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t run = first; run < last; ++run) take_run(run);
  });
  return beyond;
}

// Updates the farthest point. Points are processed in blocks of growing size, so that most points
// need only be compared with a large distance. All points of a block are compared with the same
// distance, so the result does not depend on their order. Ties are broken by the lowest index.
void take_farthest(std::span<const Vec3> points, const ClosestPointQuery& closest,
                   Farthest& farthest) {
  const std::vector<std::size_t> order = vanguard_first(points.size());
  std::size_t farthest_number = 0;  // valid only if `is_ours` is set
  bool is_ours = false;
  for (std::size_t begin = 0, size = points_per_task; begin < order.size(); begin += size) {
    size = std::min(std::max(begin, points_per_task), order.size() - begin);
    const auto numbers = std::span(order).subspan(begin, size);
    const std::vector<double> beyond =
        distances_beyond(points, numbers, closest, farthest.distance);
    for (std::size_t i = 0; i < size; ++i) {
      const bool is_first_of_equals =
          is_ours && beyond[i] == farthest.distance && numbers[i] < farthest_number;
      if (!(beyond[i] > farthest.distance) && !is_first_of_equals) continue;
      farthest = {beyond[i], points[numbers[i]]};
      farthest_number = numbers[i];
      is_ours = true;
    }
  }
}

}  // namespace

std::vector<double> vertex_distances(const Mesh& mesh, const Mesh& reference,
                                     const Progress& progress) {
  check_comparable(mesh, reference);
  return distances(mesh.positions, Distance(reference), progress, "vertex distances");
}

std::vector<double> signed_vertex_distances(const Mesh& mesh, const Mesh& reference,
                                            const Progress& progress) {
  check_comparable(mesh, reference);
  if (reference.faces.empty())
    throw InputError("the reference has no faces: signed distances need a surface");
  if (volume(reference) < 0 && check_manifold(reference).is_closed())
    throw InputError(ErrorKind::inside_out, "the reference is inside out");
  const ClosestPointQuery closest(reference);
  const auto distance = [&](const Vec3& point) { return closest(point).signed_distance; };
  return distances(mesh.positions, distance, progress, "vertex distances");
}

Farthest farthest_from(const ClosestPointQuery& reference, const Mesh& mesh,
                       const CompareOptions& options) {
  Farthest farthest;
  take_farthest(used_vertices(mesh), reference, farthest);
  take_farthest(surface_samples(mesh, options.samples, options.seed), reference, farthest);
  return farthest;
}

Comparison compare(const Mesh& mesh, const Mesh& reference, const CompareOptions& options,
                   const Progress& progress) {
  check_comparable(mesh, reference);
  const OneWay there = measure(mesh, reference, options, progress, "to the reference");
  const OneWay back = measure(reference, mesh, options, progress, "from the reference");
  const double distance = options.distance < 0
                              ? default_distance_share * diagonal_of(bounding_box(reference))
                              : options.distance;
  Comparison result;
  result.accuracy = quantile(there.by_area, accuracy_share);
  result.completeness = share_within(back.by_area, distance);
  result.mean = (there.mean + back.mean) / 2;
  result.rms = std::sqrt((there.mean_square + back.mean_square) / 2);
  result.hausdorff_to_reference = there.largest;
  result.hausdorff_from_reference = back.largest;
  result.hausdorff = std::max(there.largest, back.largest);
  result.volume_difference = volume(mesh) - volume(reference);
  return result;
}

}  // namespace transformesh
