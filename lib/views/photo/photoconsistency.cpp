#include "views/photo/photoconsistency.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "views/cameras/view.h"
#include "views/photo/warp.h"

namespace transformesh {
namespace {

/// Sums over all pairs with the same reference view, for each pixel of VisibleSurface::compared of
/// that view.
struct ReferenceSums {
  VisibleSurface room;
  WarpRoom warp_room;
  const VisibleSurface* seen = nullptr;  ///< null if the view is the reference of no pair
  GrayImage gradient;  ///< derivative of the photometric loss with respect to the pixel's depth
  GrayImage curvature;
  GrayImage count;  ///< number of pairs in which the pixel is visible
  CorrelationSums sums;
  std::size_t visible = 0;

  /// Sets all sums to 0 and prepares for another view; keeps the allocated memory.
  void begin(const VisibleSurface& surface) {
    seen = &surface;
    for (GrayImage* const image : {&gradient, &curvature, &count}) {
      image->width = surface.compared.columns();
      image->height = surface.compared.rows();
      image->pixels.assign(
          static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height), 0);
    }
  }
};

/// Sums over the pixels of a face for each of its corners, weighted by barycentric coordinates.
/// Derivatives are for movements of the face along its normal.
struct FaceSums {
  std::array<double, 3> gradient{};
  std::array<double, 3> curvature{};
  std::array<double, 3> count{};
};

void check_pairs(std::span<const View> views, std::span<const ViewPair> pairs,
                 const PhotoconsistencyOptions& options) {
  if (!(options.depth_tolerance >= 0)) throw UsageError("the depth tolerance must be at least 0");
  for (const ViewPair& pair : pairs) {
    if (pair.first < views.size() && pair.second < views.size()) continue;
    throw UsageError("views " + std::to_string(pair.first) + " and " + std::to_string(pair.second) +
                     " cannot be compared: the number of views is " + std::to_string(views.size()));
  }
}

void add_row(const CorrelationRow& row, int y, ReferenceSums& sums) {
  const int width = sums.gradient.width;
  float* gradient = sums.gradient.row(y);
  float* curvature = sums.curvature.row(y);
  float* count = sums.count.row(y);
  for (int x = 0; x < width; ++x) gradient[x] += row.gradient[x];
  for (int x = 0; x < width; ++x) curvature[x] += row.curvature[x];
  for (int x = 0; x < width; ++x) count[x] += row.is_seen[x];
}

std::size_t count_visible(const VisibleSurface& seen) {
  return static_cast<std::size_t>(std::count_if(seen.depth.pixels.begin(), seen.depth.pixels.end(),
                                                [](float depth) { return depth > 0; }));
}

void add_sums_of_pair(const Warp& warp, const VisibleSurface& seen,
                      const PhotoconsistencyOptions& options, ReferenceSums& sums) {
  const CorrelationSums pair = correlate(
      sums.gradient.width, seen.compared.first_row, seen.compared.end_row, options.correlation,
      [&](int y, const ComparedRow& row) {
        warp.row(y, options.interpolation, {row.is_seen, row.first, row.second, row.slope});
      },
      [&](int y, const CorrelationRow& row) { add_row(row, y - seen.compared.first_row, sums); });
  sums.sums.energy += pair.energy;
  sums.sums.loss += pair.loss;
  sums.sums.weight += pair.weight;
  sums.sums.pixels += pair.pixels;
}

void compare_with_others(std::size_t reference, std::span<const View> views, const SeenViews& seen,
                         std::span<const ViewPair> pairs, const PhotoconsistencyOptions& options,
                         ReferenceSums& sums) {
  const auto is_of_reference = [&](const ViewPair& pair) { return pair.first == reference; };
  sums.seen = nullptr;
  sums.sums = {};
  sums.visible = 0;
  if (std::none_of(pairs.begin(), pairs.end(), is_of_reference)) return;
  const VisibleSurface& from = seen.surface(reference, sums.room);
  if (from.compared.first_row >= from.compared.end_row) return;
  sums.begin(from);
  const std::size_t visible = count_visible(from);
  for (const ViewPair& pair : pairs) {
    if (!is_of_reference(pair)) continue;
    sums.visible += visible;
    const Warp warp(views[reference], from, views[pair.second], seen.depths(pair.second),
                    options.depth_tolerance, sums.warp_room);
    add_sums_of_pair(warp, from, options, sums);
  }
}

/// Adds the sums of each pixel to the corners of its face.
void add_to_faces(const ReferenceSums& sums, std::vector<FaceSums>& faces) {
  if (sums.seen == nullptr) return;
  const VisibleSurface& seen = *sums.seen;
  const int left = seen.compared.first_column - seen.box.first_column;
  const int top = seen.compared.first_row - seen.box.first_row;
  for (int y = 0; y < sums.count.height; ++y) {
    for (int x = 0; x < sums.count.width; ++x) {
      const double count = sums.count.at(x, y);
      if (count == 0) continue;
      const FacePixel& pixel = seen.faces.at(x + left, y + top);
      const double inverse = seen.inverse_facing.at(x + left, y + top);
      const double gradient = sums.gradient.at(x, y) * inverse;
      const double curvature = sums.curvature.at(x, y) * inverse * inverse;
      const std::array<double, 3> share{pixel.weight[0], pixel.weight[1],
                                        1.0 - pixel.weight[0] - pixel.weight[1]};
      FaceSums& face = faces[pixel.face];
      for (std::size_t i = 0; i < 3; ++i) {
        face.gradient[i] += share[i] * gradient;
        face.curvature[i] += share[i] * curvature;
        face.count[i] += share[i] * count;
      }
    }
  }
}

void add_sums_to_vertices(const Mesh& mesh, const std::vector<FaceSums>& faces,
                          Photoconsistency& result) {
  result.gradient.assign(mesh.positions.size(), Vec3::Zero());
  result.curvature.assign(mesh.positions.size(), 0);
  result.coverage.assign(mesh.positions.size(), 0);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (faces[f].count == std::array<double, 3>{}) continue;
    const Vec3 normal = face_normal(mesh, static_cast<Index>(f)).normalized();
    for (std::size_t i = 0; i < 3; ++i) {
      const Index vertex = mesh.faces[f][i];
      result.gradient[vertex] += faces[f].gradient[i] * normal;
      result.curvature[vertex] += faces[f].curvature[i];
      result.coverage[vertex] += faces[f].count[i];
    }
  }
}

void add_sums_of_view(const ReferenceSums& sums, Photoconsistency& result,
                      std::vector<FaceSums>& faces) {
  result.energy += sums.sums.energy;
  result.loss += sums.sums.loss;
  result.weight += sums.sums.weight;
  result.pixels += sums.sums.pixels;
  result.visible += sums.visible;
  add_to_faces(sums, faces);
}

}  // namespace

Photoconsistency photoconsistency(const Mesh& mesh, std::span<const View> views,
                                  const SeenViews& seen, std::span<const ViewPair> pairs,
                                  const PhotoconsistencyOptions& options,
                                  const Progress& progress) {
  check_pairs(views, pairs, options);
  progress("compare");
  Photoconsistency result;
  std::vector<FaceSums> faces(mesh.faces.size());
  // To save memory, at most one view per thread is compared at the same time. Sums are added in the
  // order of the views, so that the result does not depend on the number of threads.
  std::vector<ReferenceSums> sums(std::min(allowed_thread_count(), views.size()));
  for (std::size_t start = 0; start < views.size(); start += sums.size()) {
    const std::size_t count = std::min(sums.size(), views.size() - start);
    parallel_for(count, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v)
        compare_with_others(start + v, views, seen, pairs, options, sums[v]);
    });
    for (std::size_t v = 0; v < count; ++v) add_sums_of_view(sums[v], result, faces);
  }
  progress("add up");
  sums = {};
  add_sums_to_vertices(mesh, faces, result);
  return result;
}

}  // namespace transformesh
