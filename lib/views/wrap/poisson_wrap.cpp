#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Poisson_reconstruction_function.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "support/random.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "transformesh/wrap.h"
#include "views/hull/marching_tetrahedra.h"
#include "views/wrap/numbered_poisson_cells.h"
#include "views/wrap/scale_normalization.h"

namespace transformesh {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Function = CGAL::Poisson_reconstruction_function<Kernel>;
// Otherwise the result would depend on memory addresses (numbered_poisson_cells.h).
static_assert(Function::Triangulation::Cell::Has_timestamp::value);
using PointMap = CGAL::First_of_pair_property_map<Oriented>;
using NormalMap = CGAL::Second_of_pair_property_map<Oriented>;

/// The spacing of the points is their mean distance to this many nearest neighbors.
constexpr unsigned neighbors = 6;
/// The side of a grid cell is the spacing of the points, limited so that the diagonal of the
/// bounding box has between `least_cells` and `most_cells` cells.
constexpr double least_cells = 16;
constexpr double most_cells = 160;
/// Largest random shift of a point along each axis, as a fraction of the spacing (see
/// rising_function()).
constexpr double shaken_by_spacing = 0.03;
constexpr double margin_by_diagonal = 0.1;  ///< margin of the grid, as a fraction of the diagonal
/// Value at nodes of the grid's boundary, and where CGAL's function has no finite value.
constexpr float outside = 1;

/// Returns a normal for each point. The first of several equal points gets the sum of their unit
/// normals, the others get 0. A point without equal points keeps its normal, with its length.
std::vector<Vec3> sums_at_firsts(std::span<const Vec3> points, std::span<const Vec3> normals) {
  const std::vector<std::size_t> first = first_equals(points);
  std::vector<Vec3> sums(normals.begin(), normals.end());
  sums.resize(points.size(), Vec3::Zero());
  std::vector<char> is_sum(points.size(), 0);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    Vec3& sum = sums[first[i]];
    if (first[i] == i || sums[i].isZero()) continue;
    if (!is_sum[first[i]] && !sum.isZero()) sum.normalize();
    is_sum[first[i]] = 1;
    sum += sums[i].normalized();
    sums[i].setZero();
  }
  return sums;
}

std::vector<Oriented> oriented_points(std::span<const Vec3> points, std::span<const Vec3> normals) {
  const std::vector<Vec3> sums = sums_at_firsts(points, normals);
  std::vector<Oriented> cloud;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (sums[i].isZero()) continue;
    const Vec3 n = sums[i].normalized();
    cloud.emplace_back(Kernel::Point_3(points[i].x(), points[i].y(), points[i].z()),
                       Kernel::Vector_3(n.x(), n.y(), n.z()));
  }
  return cloud;
}

bool is_in_plane(const std::vector<Oriented>& cloud) {
  const auto& first = cloud.front().first;
  const auto is_apart = [&](const Oriented& oriented) { return oriented.first != first; };
  const auto second = std::find_if(cloud.begin(), cloud.end(), is_apart);
  if (second == cloud.end()) return true;
  const auto is_beside = [&](const Oriented& oriented) {
    return !CGAL::collinear(first, second->first, oriented.first);
  };
  const auto third = std::find_if(second, cloud.end(), is_beside);
  if (third == cloud.end()) return true;
  return std::all_of(third, cloud.end(), [&](const Oriented& oriented) {
    return CGAL::coplanar(first, second->first, third->first, oriented.first);
  });
}

std::vector<Vec3> positions_of(const std::vector<Oriented>& cloud) {
  std::vector<Vec3> positions;
  positions.reserve(cloud.size());
  for (const auto& [point, normal] : cloud) positions.emplace_back(point.x(), point.y(), point.z());
  return positions;
}

float value_at(const Function& function, const ValueGrid& grid,
               const std::array<std::size_t, 3>& site) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (site[axis] == 0 || site[axis] + 1 == grid.nodes[axis]) return outside;
  const Vec3 place = grid.position(site[0], site[1], site[2]);
  const double value = function(Kernel::Point_3(place.x(), place.y(), place.z()));
  return std::isfinite(value) ? static_cast<float>(value) : outside;
}

/// True if the Poisson function increases along the normal at half of the points or more, as it
/// should if normals point outwards.
bool rises_outwards(const Function& function, const std::vector<Oriented>& cloud, double step) {
  const auto rises = [&](const Oriented& oriented) {
    const auto& [point, normal] = oriented;
    return function(point + step * normal) > function(point - step * normal);
  };
  const auto rising = std::count_if(cloud.begin(), cloud.end(), rises);
  return 2 * static_cast<std::size_t>(rising) >= cloud.size();
}

/// Shifts each point randomly by up to `reach` along each axis. The shifts are the same in every
/// run.
std::vector<Oriented> shaken(std::vector<Oriented> cloud, double reach) {
  Random random(1);
  const auto way = [&] { return random.uniform(-reach, reach); };
  for (auto& [point, normal] : cloud) {
    const Kernel::Vector_3 shift(way(), way(), way());
    point = point + shift;
  }
  return cloud;
}

/// Returns the Poisson function of the points, or null if CGAL finds none.
std::unique_ptr<Function> function_of(const std::vector<Oriented>& cloud) {
  auto function = std::make_unique<Function>(cloud.begin(), cloud.end(), PointMap(), NormalMap());
  if (!function->compute_implicit_function()) return nullptr;
  return function;
}

/// Returns the Poisson function, which increases along normals. Computes it from randomly shifted
/// points if necessary. Returns null if CGAL finds none.
///
/// If points lie on a sphere, all Delaunay cells have the same circumcenter. CGAL's refinement of
/// the Delaunay triangulation then stops before the space around the points is subdivided. The
/// function is constant there, so that its sign is arbitrary. Shifted points do not lie on a
/// sphere.
std::unique_ptr<Function> rising_function(const std::vector<Oriented>& cloud, double spacing) {
  std::unique_ptr<Function> function = function_of(cloud);
  if (function == nullptr || rises_outwards(*function, cloud, spacing / 2)) return function;
  function = function_of(shaken(cloud, shaken_by_spacing * spacing));
  if (function == nullptr || rises_outwards(*function, cloud, spacing / 2)) return function;
  throw GoalError(
      "no surface fits these normals: most point inwards, or they contradict each other");
}

/// Samples the function on a grid around the points. The grid has a margin, because the surface may
/// extend beyond the points.
ValueGrid sampled(const Function& function, const Box& box, double cell) {
  ValueGrid grid;
  grid.spacing = cell;
  const Vec3 margin = Vec3::Constant(margin_by_diagonal * diagonal_of(box) + 2 * cell);
  grid.origin = box.min() - margin;
  const Vec3 size = box.max() + margin - grid.origin;
  for (int axis = 0; axis < 3; ++axis)
    grid.nodes[axis] = static_cast<std::size_t>(std::ceil(size[axis] / cell)) + 1;
  // Evaluate adjacent nodes one after the other: the function starts its search for the Delaunay
  // cell at the previous location.
  for (std::size_t z = 0; z < grid.nodes[2]; ++z)
    for (std::size_t y = 0; y < grid.nodes[1]; ++y)
      for (std::size_t x = 0; x < grid.nodes[0]; ++x)
        grid.values.push_back(value_at(function, grid, {x, y, z}));
  return grid;
}

/// Returns the Poisson surface of points of about unit size, or an empty mesh if CGAL finds no
/// function.
Mesh unit_wrap(const std::vector<Oriented>& cloud) {
  Mesh points;
  points.positions = positions_of(cloud);
  const Box box = bounding_box(points);
  const double spacing = CGAL::compute_average_spacing<CGAL::Sequential_tag>(
      cloud, neighbors, CGAL::parameters::point_map(PointMap()));
  const double cell =
      std::clamp(spacing, diagonal_of(box) / most_cells, diagonal_of(box) / least_cells);

  const std::unique_ptr<Function> function = rising_function(cloud, spacing);
  if (function == nullptr) return {};
  return march_tetrahedra(sampled(*function, box, cell));
}

}  // namespace

Mesh poisson_wrap(std::span<const Vec3> points, std::span<const Vec3> normals) {
  const std::vector<Oriented> given = oriented_points(points, normals);
  if (given.size() < 4) throw InputError("fewer than four points have normals");
  if (is_in_plane(given)) throw InputError("all points lie in one plane");
  const double diagonal = diagonal_of(positions_of(given));
  const ScaleNormalization scale(diagonal);
  check_detail(positions_of(given), diagonal / most_cells, diagonal);
  Mesh mesh = unit_wrap(oriented_points(scale.to_unit(points), normals));
  check_wrap(mesh);
  scale.from_unit(mesh);
  return mesh;
}

}  // namespace transformesh
