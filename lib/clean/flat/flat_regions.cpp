#include "clean/flat/flat_regions.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <bit>
#include <cmath>

#include "clean/rounding/triangle_distance.h"
#include "mesh/coordinate_spacing.h"

namespace transformesh {
namespace {

/// Least height of the first face of a region, in multiples of the tolerance. The plane of a lower
/// face would deviate from the surface because of rounding. A choice: a lower limit finds more
/// regions and less reliable planes.
constexpr double least_height = 64;

bool are_equal_rows(const Column& column, Index a, Index b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  const std::vector<double>& values = column.values;
  if (!column.list_count_type) return same(values[a], values[b]);
  const auto at = [&](std::size_t row) {
    return values.begin() + static_cast<std::ptrdiff_t>(column.list_offsets[row]);
  };
  return std::equal(at(a), at(a + 1), at(b), at(b + 1), same);
}

/// Returns the least height of a triangle: twice its area divided by its longest edge.
double height_of(const Triangle& t) {
  const double longest = std::max(
      {(t[1] - t[0]).stableNorm(), (t[2] - t[1]).stableNorm(), (t[0] - t[2]).stableNorm()});
  return longest * relative_height(t);
}

class RegionFinder {
 public:
  RegionFinder(const Mesh& mesh, std::span<const Index> opposites, std::span<const char> wanted,
               double spacings, Scalar coordinate)
      : mesh_(mesh),
        opposites_(opposites),
        wanted_(wanted),
        spacings_(spacings),
        coordinate_(coordinate) {
    found_.of_face.assign(mesh.faces.size(), no_index);
  }
  FlatRegions find();

 private:
  std::vector<Index> seeds() const;
  void grow_from(Index seed);
  void grow(std::vector<Index> front);
  bool belongs(Index face, Index beside) const;
  double distance(Index vertex) const { return plane_.normal.dot(at(vertex) - plane_.point); }
  const Vec3& at(Index vertex) const { return mesh_.positions[vertex]; }
  bool fit();
  FlatRegion fitted() const;
  void measure(FlatRegion& region) const;
  void finish();

  const Mesh& mesh_;
  std::span<const Index> opposites_;
  std::span<const char> wanted_;
  double spacings_;
  Scalar coordinate_;
  FlatRegion plane_;  ///< the region that is growing
  double tolerance_ = 0;
  FlatRegions found_;
};

/// Returns the faces from which regions may grow, the largest first: faces that the caller wants,
/// and their neighbors.
std::vector<Index> RegionFinder::seeds() const {
  std::vector<std::pair<double, Index>> faces;
  for (Index f = 0; f < mesh_.faces.size(); ++f) {
    bool is_seed = wanted_[f] != 0;
    for (Index i = 0; i < 3 && !is_seed; ++i) {
      const Index across = opposites_[3 * f + i];
      is_seed = across != no_index && wanted_[across / 3] != 0;
    }
    if (!is_seed) continue;
    const auto [a, b, c] = triangle_of(mesh_, f);
    faces.emplace_back(-normal_of(a, b, c).stableNorm(), f);
  }
  std::sort(faces.begin(), faces.end());
  std::vector<Index> seeds;
  seeds.reserve(faces.size());
  for (const auto& [area, face] : faces) seeds.push_back(face);
  return seeds;
}

bool RegionFinder::belongs(Index face, Index beside) const {
  if (found_.of_face[face] != no_index) return false;
  for (const Index v : mesh_.faces[face])
    if (!(std::abs(distance(v)) <= tolerance_)) return false;
  for (const Column& column : mesh_.face_columns.columns)
    if (!are_equal_rows(column, face, beside)) return false;
  const Triangle triangle = triangle_of(mesh_, face);
  return unit_normal(triangle).dot(plane_.normal) > 0 || height_of(triangle) <= 2 * tolerance_;
}

void RegionFinder::grow(std::vector<Index> front) {
  const auto region = static_cast<Index>(found_.regions.size());
  while (!front.empty()) {
    const Index face = front.back();
    front.pop_back();
    for (Index i = 0; i < 3; ++i) {
      const Index across = opposites_[3 * face + i];
      if (across == no_index || !belongs(across / 3, face)) continue;
      found_.of_face[across / 3] = region;
      plane_.faces.push_back(across / 3);
      front.push_back(across / 3);
    }
  }
}

void RegionFinder::measure(FlatRegion& region) const {
  region.low = region.high = 0;
  for (const Index face : region.faces)
    for (const Index v : mesh_.faces[face]) {
      const double height = region.normal.dot(at(v) - region.point);
      region.low = std::min(region.low, height);
      region.high = std::max(region.high, height);
    }
}

/// Returns the growing region with a plane that is fitted to all corners by least squares of
/// distances.
FlatRegion RegionFinder::fitted() const {
  FlatRegion fitted = plane_;
  Vec3 mean = Vec3::Zero();
  const double share = 1 / (3 * static_cast<double>(plane_.faces.size()));
  for (const Index face : plane_.faces)
    for (const Index v : mesh_.faces[face]) mean += share * (at(v) - plane_.point);
  fitted.point += mean;
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const Index face : plane_.faces)
    for (const Index v : mesh_.faces[face]) {
      const Vec3 d = at(v) - fitted.point;
      squares += d * d.transpose();
    }
  const Vec3 normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(squares).eigenvectors().col(0);
  fitted.normal = normal.dot(plane_.normal) < 0 ? Vec3(-normal) : normal;
  measure(fitted);
  return fitted;
}

/// Fits the plane of the growing region to all corners. The fit must reduce the extent of the
/// region along the normal, and all corners must be within the tolerance of the new plane.
/// Otherwise returns false and changes nothing.
bool RegionFinder::fit() {
  FlatRegion better = fitted();
  if (!(better.high - better.low < plane_.high - plane_.low) || better.high > tolerance_ ||
      better.low < -tolerance_)
    return false;
  plane_ = std::move(better);
  return true;
}

void RegionFinder::grow_from(Index seed) {
  const Triangle triangle = triangle_of(mesh_, seed);
  double spacing = 0;
  for (const Vec3& corner : triangle)
    spacing = std::max(spacing, spacing_around(corner, coordinate_));
  tolerance_ = spacings_ * spacing;
  if (!(height_of(triangle) > least_height * tolerance_)) return;
  plane_ = {triangle[0], unit_normal(triangle), 0, 0, {seed}};
  found_.of_face[seed] = static_cast<Index>(found_.regions.size());
  // Each round except the last one at least doubles the number of faces of the region, so the cost
  // is linear.
  for (std::size_t before = 0; 2 * before < plane_.faces.size() + 1;) {
    before = plane_.faces.size();
    grow(plane_.faces);
    measure(plane_);
    if (!fit()) break;
  }
  finish();
}

void RegionFinder::finish() {
  const bool is_wanted = std::any_of(plane_.faces.begin(), plane_.faces.end(),
                                     [&](Index face) { return wanted_[face] != 0; });
  if (plane_.faces.size() > 1 && is_wanted) {
    std::sort(plane_.faces.begin(), plane_.faces.end());
    found_.regions.push_back(std::move(plane_));
  } else {
    for (const Index face : plane_.faces) found_.of_face[face] = no_index;
  }
}

FlatRegions RegionFinder::find() {
  for (const Index seed : seeds())
    if (found_.of_face[seed] == no_index) grow_from(seed);
  return std::move(found_);
}

}  // namespace

FlatRegions find_flat_regions(const Mesh& mesh, std::span<const Index> opposites,
                              std::span<const char> wanted, double spacings, Scalar coordinate) {
  return RegionFinder(mesh, opposites, wanted, spacings, coordinate).find();
}

}  // namespace transformesh
