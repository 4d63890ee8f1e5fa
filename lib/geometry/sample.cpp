// Samples points on a surface: a given number of points uniformly by area, or a Poisson disk
// sampling with a given distance. Reference: Cline, Jeschke, White, Razdan & Wonka, "Dart throwing
// on surfaces", Computer Graphics Forum 28(4), 2009. Cost: O(n + points) on usual meshes.
#include "transformesh/sample.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "geometry/search/hashed_grid.h"
#include "geometry/surface_samples.h"
#include "mesh/surface_columns.h"
#include "mesh/triangle.h"
#include "support/number.h"
#include "support/random.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

constexpr double most_points = 1e8;  ///< largest number of points; limits memory and time
/// Number of darts (random sample points) per area distance^2 that are thrown first.
constexpr double darts_per_disk = 2;
/// Parts of faces smaller than this fraction of the sampling distance are not split further.
constexpr double tolerance = 1e-9;
/// Parts of faces smaller than this many spacings of floating-point coordinates are not split
/// further.
constexpr double roundings = 16;
/// Number of darts between two reports of progress.
constexpr std::size_t darts_per_report = 16384;

/// A triangle inside a face, given by the barycentric coordinates of its corners.
struct Part {
  Index face = 0;
  std::array<Vec3, 3> corners{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
};

class PoissonDisk {
 public:
  PoissonDisk(const Mesh& mesh, double distance, std::uint64_t seed)
      : mesh_(mesh),
        distance_(distance),
        smallest_(std::max(tolerance * distance, roundings * spacing_of(mesh))),
        random_(seed),
        grid_(distance) {}

  std::vector<SurfacePoint> sample(std::size_t darts, std::uint64_t seed,
                                   const Progress& progress) {
    // Throw darts (random points) uniformly by area, in random order. Keep a dart if no kept dart
    // is closer than the sampling distance.
    std::vector<SurfacePoint> thrown = surface_points(mesh_, darts, seed);
    for (std::size_t i = thrown.size(); i > 1; --i)
      std::swap(thrown[i - 1],
                thrown[static_cast<std::size_t>(random_.integer(0, static_cast<long>(i) - 1))]);
    for (std::size_t i = 0; i < thrown.size(); ++i) {
      if (i % darts_per_report == 0)
        progress("throw", static_cast<double>(i) / static_cast<double>(thrown.size()));
      add_if_free(thrown[i]);
    }

    // Add points where the surface is not covered yet by disks around the kept points.
    const auto faces = static_cast<Index>(mesh_.faces.size());
    for (Index face = 0; face < faces; ++face) {
      if (face % darts_per_report == 0)
        progress("fill", static_cast<double>(face) / static_cast<double>(faces));
      fill(face);
    }
    return std::move(points_);
  }

 private:
  Vec3 place(Index face, const Vec3& weights) const {
    const Face& corners = mesh_.faces[face];
    return weights[0] * mesh_.positions[corners[0]] + weights[1] * mesh_.positions[corners[1]] +
           weights[2] * mesh_.positions[corners[2]];
  }

  bool is_free(const Vec3& place) const {
    return !grid_.find_around(
        place, [&](Index other) { return (points_[other].position - place).norm() < distance_; });
  }

  bool add_if_free(const SurfacePoint& point) {
    if (!is_free(point.position)) return false;
    grid_.add(point.position, static_cast<Index>(points_.size()));
    points_.push_back(point);
    return true;
  }

  /// True if the disk around one kept point covers the whole triangle.
  bool is_covered(const Triangle& corners) const {
    return grid_.find_around(corners[0], [&](Index point) {
      const Vec3& center = points_[point].position;
      return std::ranges::all_of(corners,
                                 [&](const Vec3& p) { return (p - center).norm() < distance_; });
    });
  }

  /// Throws darts (random points) into the uncovered parts of a face. Parts are split until they
  /// are covered.
  void fill(Index face) {
    std::vector<Part> parts{{face}};
    while (!parts.empty()) {
      const Part part = parts.back();
      parts.pop_back();
      const Triangle corners{place(face, part.corners[0]), place(face, part.corners[1]),
                             place(face, part.corners[2])};
      if (is_covered(corners)) continue;
      if (longest(corners) < smallest_) {
        add_if_free({face, middle_of(part), place(face, middle_of(part))});
        continue;
      }
      const Vec3 weights = random_weights(part);
      const bool is_added = add_if_free({face, weights, place(face, weights)});
      if (!is_added || !is_covered(corners)) halve(part, corners, parts);
    }
  }

  static double spacing_of(const Mesh& mesh) {
    double most = 0;
    for (const Vec3& p : mesh.positions) most = std::max(most, p.cwiseAbs().maxCoeff());
    return most * std::numeric_limits<double>::epsilon();
  }

  static double longest(const Triangle& corners) {
    return std::max({(corners[1] - corners[0]).norm(), (corners[2] - corners[1]).norm(),
                     (corners[0] - corners[2]).norm()});
  }

  static Vec3 middle_of(const Part& part) {
    return (part.corners[0] + part.corners[1] + part.corners[2]) / 3;
  }

  Vec3 random_weights(const Part& part) {
    const double root = std::sqrt(random_.uniform(0, 1));
    const double second = random_.uniform(0, 1);
    return (1 - root) * part.corners[0] + root * (1 - second) * part.corners[1] +
           root * second * part.corners[2];
  }

  /// Splits a part at the midpoint of its longest edge.
  static void halve(const Part& part, const Triangle& corners, std::vector<Part>& parts) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if ((corners[(i + 1) % 3] - corners[i]).norm() >
          (corners[(longest + 1) % 3] - corners[longest]).norm())
        longest = i;
    const std::size_t next = (longest + 1) % 3;
    const Vec3 middle = (part.corners[longest] + part.corners[next]) / 2;
    Part half = part;
    half.corners[longest] = middle;
    parts.push_back(half);
    half = part;
    half.corners[next] = middle;
    parts.push_back(half);
  }

  const Mesh& mesh_;
  double distance_;
  double smallest_;  ///< longest edge below which parts of faces are not split
  Random random_;
  HashedGrid grid_;
  std::vector<SurfacePoint> points_;
};

double checked_area(const Mesh& mesh) {
  const double area = surface_area(mesh);
  if (mesh.faces.empty()) throw InputError("the mesh has no faces: there is no surface to sample");
  if (!(area > 0)) throw InputError("the surface has no area to sample: scale it up");
  if (!std::isfinite(area))
    throw InputError(
        "the area of the mesh is beyond the range of double precision: scale the mesh down");
  return area;
}

std::vector<SurfacePoint> poisson_disk(const Mesh& mesh, const SampleOptions& options,
                                       const Progress& progress) {
  const double disks = checked_area(mesh) / options.distance / options.distance;
  if (!(disks < most_points))
    throw UsageError("a distance of " + shortest_text(options.distance) + " makes about " +
                     significant(disks, 2) + " points, more than the maximum of " +
                     shortest_text(most_points) + ": ask for a larger distance");
  const auto darts = static_cast<std::size_t>(std::ceil(darts_per_disk * disks));
  return PoissonDisk(mesh, options.distance, options.seed).sample(darts, options.seed, progress);
}

/// Returns the unit normal of a face of any size, or zero if all corners are equal.
Vec3 unit_normal(const Triangle& corners) {
  const Vec3 u = corners[1] - corners[0];
  const Vec3 v = corners[2] - corners[0];
  const double size = std::max(u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff());
  if (!(size > 0)) return Vec3::Zero();
  return (u / size).cross(v / size).stableNormalized();
}

/// Copies the columns of faces to the sample points on these faces.
void take_face_columns(const Mesh& mesh, const std::vector<SurfacePoint>& points, Mesh& result) {
  std::vector<Index> faces;
  for (const SurfacePoint& point : points) faces.push_back(point.face);
  Columns rows = mesh.face_columns.select(faces);
  drop_corner_lists(rows);
  for (Column& column : rows.columns)
    if (result.vertex_columns.find(column.name) == nullptr)
      result.vertex_columns.columns.push_back(std::move(column));
}

void set_normals(const Mesh& mesh, const std::vector<SurfacePoint>& points, Mesh& result) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::array<const char*, 3> names{"nx", "ny", "nz"};
    Column& column = result.vertex_columns.get(names[static_cast<std::size_t>(axis)],
                                               Scalar::float64, points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      column.values[i] = unit_normal(triangle_of(mesh, points[i].face))[axis];
  }
}

}  // namespace

Mesh sample_surface(const Mesh& mesh, const SampleOptions& options, const Progress& progress) {
  if ((options.count > 0) == (options.distance > 0))
    throw UsageError("give either a count of points or their distance");
  checked_area(mesh);
  progress("sample");
  const std::vector<SurfacePoint> points = options.count > 0
                                               ? surface_points(mesh, options.count, options.seed)
                                               : poisson_disk(mesh, options, progress);

  std::vector<RowBlend> blends;
  Mesh result;
  for (const SurfacePoint& point : points) {
    const Vec3& w = point.weights;
    blends.push_back({mesh.faces[point.face], {w[0], w[1], w[2]}});
    result.positions.push_back(point.position);
  }
  result.vertex_columns = mesh.vertex_columns.blend(blends);
  take_face_columns(mesh, points, result);
  set_normals(mesh, points, result);
  return result;
}

}  // namespace transformesh
