#include "reconstruction/filled_hollows.h"

#include <algorithm>

#include "mesh/local_measures.h"
#include "reconstruction/start_comparison.h"
#include "reconstruction/surface_doubt.h"
#include "transformesh/measure.h"
#include "views/photo/thin_plate.h"

namespace transformesh {
namespace {

/// Least WindowSums::excess of a vertex in a filled hollow. Films across bores of 9 pixels had 0.4
/// to 0.7 in their middle.
constexpr double least_excess = 0.4;
/// Least area of a filled hollow in squared pixels: a bore of eight pixels. With half of it, few
/// windows decide: on the true surface of the dumbbell (120x90), noise made a place of 39.
constexpr double least_hollow_px = 50;
/// Depth of the trial, in pixels. At 4 pixels, errors that are only two pixels deep also reduced
/// the excess clearly. At 6 pixels the ratio was 0.52 to 0.67 on films across bores of 17 and 24
/// pixels, and above 0.84 at creases.
constexpr double trial_depth_px = 6;
/// Least cosine between a normal and the mean normal of a place. Without this limit, creases of two
/// right results were reported (boxes, 120x90 and 160x120), which are rounded by some pixels.
constexpr double least_flatness = 0.8;

/// A connected set of vertices, followed by its neighbors.
struct HollowPlace {
  std::vector<Index> vertices;
  std::size_t count = 0;  ///< number of vertices without the neighbors

  WindowSums sum(const std::vector<WindowSums>& sums) const {
    WindowSums sum;
    for (const Index v : vertices) sum += sums[v];
    return sum;
  }
};

HollowPlace with_neighbors(std::vector<Index> vertices, const UniformLaplacian& laplacian,
                           std::vector<bool>& is_in_place) {
  HollowPlace place{std::move(vertices)};
  place.count = place.vertices.size();
  for (const Index v : place.vertices) is_in_place[v] = true;
  for (std::size_t i = 0; i < place.count; ++i) {
    for (const Index neighbor : laplacian.neighbors(place.vertices[i])) {
      if (!is_in_place[neighbor]) place.vertices.push_back(neighbor);
      is_in_place[neighbor] = true;
    }
  }
  for (const Index v : place.vertices) is_in_place[v] = false;
  return place;
}

bool is_flat(const HollowPlace& place, const std::vector<Vec3>& normals,
             const std::vector<double>& areas) {
  Vec3 mean = Vec3::Zero();
  for (const Index v : place.vertices) mean += areas[v] * normals[v];
  const double least = least_flatness * mean.norm();
  return std::ranges::all_of(place.vertices,
                             [&](Index v) { return mean.dot(normals[v]) >= least; });
}

double confirmed(const WindowSums& sums) { return sums.weight * (1 - sums.excess()); }

}  // namespace

std::vector<std::vector<Index>> filled_hollows(
    const Mesh& mesh, const std::vector<WindowSums>& sums, double pixel,
    const std::function<std::vector<WindowSums>(const Mesh&)>& measure) {
  const UniformLaplacian laplacian(mesh);
  const std::vector<double> areas = vertex_areas(mesh);
  const std::vector<Vec3> normals = vertex_normals(mesh);
  std::vector<bool> is_marked;
  for (const WindowSums& around : sums) is_marked.push_back(around.excess() > least_excess);
  std::vector<HollowPlace> places;
  std::vector<bool> is_in_place(mesh.positions.size());
  for (Index v = 0; v < is_marked.size(); ++v) {
    if (!is_marked[v]) continue;
    HollowPlace place =
        with_neighbors(take_connected(v, laplacian, is_marked), laplacian, is_in_place);
    double area = 0;
    for (std::size_t i = 0; i < place.count; ++i) area += areas[place.vertices[i]];
    if (area >= least_hollow_px * pixel * pixel && is_flat(place, normals, areas))
      places.push_back(std::move(place));
  }
  if (places.empty()) return {};

  Mesh deeper = mesh;
  for (const HollowPlace& place : places)
    for (std::size_t i = 0; i < place.count; ++i)
      deeper.positions[place.vertices[i]] -= trial_depth_px * pixel * normals[place.vertices[i]];
  const std::vector<WindowSums> trial = measure(deeper);
  std::vector<std::vector<Index>> hollows;
  for (HollowPlace& place : places) {
    const WindowSums before = place.sum(sums);
    const WindowSums after = place.sum(trial);
    if (!is_clearly_less(after.excess(), before.excess()) || confirmed(after) < confirmed(before))
      continue;
    place.vertices.resize(place.count);
    hollows.push_back(std::move(place.vertices));
  }
  return hollows;
}

}  // namespace transformesh
