#include "transformesh/offset.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evolution/loop/stages.h"
#include "evolution/loop/stop_rules.h"
#include "geometry/search/closest_point.h"
#include "geometry/surface_samples.h"
#include "io/document/round_as_written.h"
#include "io/length_basis.h"
#include "mesh/triangle.h"
#include "support/number.h"
#include "support/parallel.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/length.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

constexpr std::size_t points_per_task = 512;  ///< affects time only
/// Number of sample points per surface for measuring the deviation. With more points, smaller
/// deviations are found; time is proportional to their number.
constexpr std::size_t distance_samples = 40000;

/// Iterations end if the root mean square distance of the vertices from the offset surface is at
/// most this fraction of an edge.
constexpr double close_enough = 0.01;

/// Shortest and longest default edge, as fractions of the bounding box diagonal. The shortest
/// limits the number of faces; the longest limits the error on coarse meshes.
constexpr double least_edge = 1.0 / 400;
constexpr double most_edge = 1.0 / 60;

/// Longest default edge as a fraction of the offset distance, so that a rounded edge has several
/// faces across.
constexpr double most_share = 0.5;

/// A component is removed if its root mean square distance from the offset surface exceeds this
/// fraction of an edge. Inward offsets leave such components in parts of the source that are too
/// thin.
constexpr double shard_deviation = 0.5;

/// Iterations also end if the root mean square distance has not improved for this many iterations.
constexpr std::size_t patience = 8;

/// A vertex closer to the source than this fraction of the offset distance moves along its own
/// normal. The reason: the direction from the closest point would be rounding error.
constexpr double at_source = 1e-6;

/// The result counts as incomplete if a point of the true offset is farther from it than this many
/// edge lengths. Corners of boxes are cut off by up to 0.52 edge lengths. At half this value, every
/// box gives a warning. At twice this value, a plate as thick as 2/3 of an edge loses 1/20 of its
/// volume without a warning.
constexpr double most_missed = 0.75;

/// A point counts as on the true offset if its distance from the source differs from the offset
/// distance by at most this fraction.
constexpr double on_offset = 1e-6;

void check(const Mesh& mesh, double distance) {
  if (!std::isfinite(distance) || distance == 0)
    throw UsageError("the distance must be a length other than 0");
  if (mesh.faces.empty()) throw InputError("the mesh has no faces, so it has no offset");
  const ManifoldReport found = check_manifold(mesh);
  if (!found.is_closed())
    throw InputError(ErrorKind::not_closed,
                     "the mesh is open, but only a closed mesh has an offset");
  if (!found.is_manifold() || !found.is_oriented())
    throw InputError(ErrorKind::not_manifold, "the mesh is not an oriented manifold");
}

class Offset {
 public:
  Offset(const Mesh& source, double distance)
      : source_(source), distance_(distance), query_(source) {}

  /// Returns for each vertex the vector from it to the offset surface, along the gradient of the
  /// distance from the source.
  std::vector<Vec3> ways(const Mesh& mesh);
  OffsetDeviation deviation(const Mesh& mesh, const Progress& progress) const;
  /// Returns the root mean square length of the vectors that ways() returned last.
  double rms() const { return rms_; }
  /// Removes components that are far from the offset surface (`shard_deviation`). Returns the
  /// topology of the remaining mesh, which is `known` if nothing is removed.
  Topology drop_shards(Mesh& mesh, double edge, const Topology& known) const;

 private:
  void measure_excess(const Mesh& mesh, OffsetDeviation& result) const;
  void measure_missed(const Mesh& mesh, OffsetDeviation& result) const;
  double excess(const Vec3& point) const { return query_(point).signed_distance - distance_; }
  bool is_on_offset(const Vec3& point) const {
    return std::abs(excess(point)) <= on_offset * std::abs(distance_);
  }

  const Mesh& source_;
  double distance_;
  ClosestPointQuery query_;
  /// Result of rms(); infinite before ways() is called.
  double rms_ = std::numeric_limits<double>::infinity();
};

std::vector<Vec3> Offset::ways(const Mesh& mesh) {
  const std::vector<Vec3> normals = vertex_normals(mesh);
  std::vector<Vec3> ways(mesh.positions.size());
  parallel_for(ways.size(), points_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      const ClosestPoint closest = query_(mesh.positions[v]);
      const bool is_at_source = closest.distance <= at_source * std::abs(distance_);
      const Vec3 gradient =
          is_at_source ? normals[v]
                       : Vec3((mesh.positions[v] - closest.point) / closest.signed_distance);
      ways[v] = (distance_ - closest.signed_distance) * gradient;
    }
  });
  double squares = 0;
  for (const Vec3& way : ways) squares += way.squaredNorm();
  rms_ = std::sqrt(squares / static_cast<double>(ways.size()));
  return ways;
}

OffsetDeviation Offset::deviation(const Mesh& mesh, const Progress& progress) const {
  progress("measure");
  OffsetDeviation result;
  measure_excess(mesh, result);
  measure_missed(mesh, result);
  return result;
}

// Measures the deviation from the offset surface at sample points of the faces as well as at
// vertices. Vertices were moved onto the offset surface, so that deviations are larger between
// them.
void Offset::measure_excess(const Mesh& mesh, OffsetDeviation& result) const {
  const std::vector<Vec3> points = surface_samples(mesh, distance_samples, 1);
  std::vector<double> off(points.size() + mesh.positions.size());
  parallel_for(off.size(), points_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      off[i] = std::abs(excess(i < points.size() ? points[i] : mesh.positions[i - points.size()]));
  });
  double squares = 0;
  for (std::size_t i = 0; i < points.size(); ++i) squares += off[i] * off[i];
  result.rms = std::sqrt(squares / static_cast<double>(points.size()));
  for (const double length : off) result.most = std::max(result.most, length);
}

// Measures how far points of the true offset surface are from the result. These points are sample
// points of the source, moved along their normals. Points that are closer to another part of the
// source are left out.
void Offset::measure_missed(const Mesh& mesh, OffsetDeviation& result) const {
  const ClosestPointQuery to_result(mesh);
  std::vector<Vec3> goals = surface_samples(source_, distance_samples, 2);
  std::vector<double> missed(goals.size(), 0);
  parallel_for(goals.size(), points_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      goals[i] += distance_ * query_(goals[i]).pseudonormal;
      if (is_on_offset(goals[i])) missed[i] = to_result(goals[i]).distance;
    }
  });
  for (std::size_t i = 0; i < goals.size(); ++i) {
    if (!(missed[i] > result.missed)) continue;
    result.missed = missed[i];
    result.missed_at = goals[i];
  }
}

Topology Offset::drop_shards(Mesh& mesh, double edge, const Topology& known) const {
  const Components all = connected_components(mesh);
  std::vector<double> squares(all.components.size(), 0);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Triangle t = triangle_of(mesh.positions, mesh.faces[f]);
    const double off = excess((t[0] + t[1] + t[2]) / 3);
    squares[all.of_face[f]] +=
        off * off / static_cast<double>(all.components[all.of_face[f]].faces);
  }
  const double most = shard_deviation * edge;
  const auto is_shard = [&](double mean_square) { return mean_square > most * most; };
  if (std::none_of(squares.begin(), squares.end(), is_shard)) return known;
  std::vector<bool> keep(mesh.faces.size());
  for (Index f = 0; f < keep.size(); ++f) keep[f] = !is_shard(squares[all.of_face[f]]);
  mesh = select_faces(mesh, keep);
  const Components left = connected_components(mesh);
  return {left.components.size(), left.genus()};
}

}  // namespace

double offset_edge(const Mesh& mesh, double distance) {
  const double diagonal = diagonal_of(bounding_box(mesh));
  const double edge = std::min(
      {measured_reference_edge(mesh), most_share * std::abs(distance), most_edge * diagonal});
  return std::max(edge, least_edge * diagonal);
}

namespace {

double edge_of(const Mesh& mesh, const OffsetOptions& options) {
  return options.edge > 0 ? options.edge : offset_edge(mesh, options.distance);
}

/// Removes slivers. Their normals are mostly rounding error and would misdirect vertices. Remeshing
/// with zero iterations removes slivers only (remesh.h).
void remove_slivers(Document& document, const OffsetOptions& options, const Progress& progress) {
  const double edge = edge_of(document.mesh, options);
  RemeshOptions removal;
  removal.min_edge = 0.7 * edge;
  removal.max_edge = 1.5 * edge;
  removal.iterations = 0;
  removal.coordinate = document.style.coordinate;
  remesh(document.mesh, removal, progress);
}

OffsetResult offset_mesh(Document& document, const OffsetOptions& options,
                         const Progress& progress) {
  const Mesh source = document.mesh;
  IterationOptions iteration;
  iteration.reference_edge = edge_of(source, options);
  iteration.remesh = RemeshOptions();
  iteration.outermost = false;

  Offset offset(source, options.distance);
  const Step step =
      step_along([&](const Mesh& mesh, const Progress&) { return offset.ways(mesh); });
  StalledRule stalled(patience);
  OffsetResult result;
  result.edge = iteration.reference_edge;
  while (!result.has_arrived && result.iterations < options.iterations) {
    const IterationResult last = iterate(document, step, iteration, progress);
    iteration.expects_changes = last.was_cleaned;
    result.topology = last.topology;
    ++result.iterations;
    const bool is_close = offset.rms() <= close_enough * iteration.reference_edge;
    result.has_arrived = is_close || stalled.add(offset.rms());
  }

  // The last remeshing moved vertices off the offset surface. Therefore make one more step without
  // remeshing.
  step(document.mesh, progress);
  round_as_written(document);
  result.topology = clean_in_place(document, progress, false).topology;
  if (result.has_arrived)
    result.topology = offset.drop_shards(document.mesh, result.edge, result.topology);
  if (document.mesh.faces.empty()) throw GoalError("only components smaller than an edge are left");
  result.deviation = offset.deviation(document.mesh, progress);
  result.has_missed = result.deviation.missed > most_missed * result.edge;
  return result;
}

}  // namespace

OffsetResult offset(Document& document, const OffsetOptions& options, const Progress& progress) {
  check(document.mesh, options.distance);
  clean_in_place(document, progress, false);
  remove_slivers(document, options, progress);
  try {
    return offset_mesh(document, options, progress);
  } catch (const GoalError&) {
    // If an inward offset removes the whole surface, the original message would describe only the
    // part that vanished last.
    if (options.distance > 0) throw;
    throw GoalError(
        "no part of the surface is left, or its walls are too thin for its edges: probably no "
        "point lies " +
        significant(-options.distance, 3) + " inside it");
  }
}

}  // namespace transformesh
