#include "transformesh/flow.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "flow/analytic_fields.h"
#include "flow/curvature_flows.h"
#include "flow/normal_flow.h"
#include "flow/sampled_grid.h"
#include "support/parallel.h"
#include "support/suggestion.h"
#include "transformesh/velocity.h"

namespace transformesh {
namespace {

constexpr std::size_t vertices_per_task = 1024;  ///< affects time only

const FlowKind& kind_of(const std::string& name) {
  std::vector<std::string> names;
  for (const FlowKind& kind : flow_kinds()) {
    if (kind.name == name) return kind;
    names.push_back(kind.name);
  }
  const std::string nearest = nearest_name(name, names);
  throw UsageError("there is no flow '" + name +
                   (is_near(name, nearest) ? "'; did you mean '" + nearest + "'?" : "'"));
}

void refuse_unless(bool is_set, const FlowKind& kind, const std::string& parameter) {
  if (is_set && std::ranges::find(kind.parameters, parameter) == kind.parameters.end())
    throw UsageError("the flow '" + kind.name + "' has no parameter '" + parameter + "'");
}

void check(const FlowKind& kind, const FlowOptions& options) {
  refuse_unless(options.period.has_value(), kind, "period");
  refuse_unless(options.center.has_value(), kind, "center");
  refuse_unless(options.direction.has_value(), kind, "direction");
  refuse_unless(options.column.has_value(), kind, "column");
  refuse_unless(!options.grids.empty(), kind, "grid");
  if (!std::isfinite(options.speed)) throw UsageError("the speed is not a finite number");
  if (options.period && !(*options.period > 0 && std::isfinite(*options.period)))
    throw UsageError("the period must be a number above 0");
  if (options.center && !options.center->allFinite())
    throw UsageError("the center is not a finite point");
  if (options.direction && !(options.direction->allFinite() && options.direction->stableNorm() > 0))
    throw UsageError("the direction must be a finite vector other than 0");
}

/// Calls body(first, last) in parallel for ranges of vertex indices.
template <class Body>
void for_vertices(const Mesh& mesh, const Body& body) {
  parallel_for(mesh.positions.size(), vertices_per_task, body);
}

Motion analytic_motion(const AnalyticField& field, double speed) {
  return {[field, speed](const Mesh& mesh, const Moment& moment, const Progress&) {
    const VectorAt at = field(moment.time);
    std::vector<Vec3> velocities(mesh.positions.size());
    for_vertices(mesh, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) velocities[v] = speed * at(mesh.positions[v]);
    });
    return velocities;
  }};
}

/// Returns the values of the grids at the vertices. Updates `counts`: the largest number of
/// vertices outside of the grids in any call, and whether a time was outside.
std::vector<Vec3> sampled(const GridSeries& grids, const Mesh& mesh, double time,
                          FlowCounts& counts) {
  const GridSeries::Interval interval = grids.around(time);
  std::vector<Vec3> values(mesh.positions.size());
  std::vector<char> is_outside(values.size(), 0);
  for_vertices(mesh, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      const GridValue found = value_at(interval, mesh.positions[v]);
      values[v] = found.value;
      is_outside[v] = found.is_outside;
    }
  });
  const auto outside = static_cast<std::size_t>(std::ranges::count(is_outside, 1));
  counts.outside = std::max(counts.outside, outside);
  counts.is_time_outside |= interval.is_outside;
  return values;
}

Motion grid_motion(const FlowOptions& options, const std::shared_ptr<FlowCounts>& counts) {
  const auto grids = std::make_shared<const GridSeries>(options.grids, 3);
  return {[=, speed = options.speed](const Mesh& mesh, const Moment& moment, const Progress&) {
    std::vector<Vec3> velocities = sampled(*grids, mesh, moment.time, *counts);
    for (Vec3& velocity : velocities) velocity *= speed;
    return velocities;
  }};
}

/// Returns a motion whose speed at each vertex is the product of options.speed, the column and the
/// grid. A column or grid that is not given counts as 1.
Motion normal_motion(const FlowOptions& options, const std::shared_ptr<FlowCounts>& counts) {
  std::shared_ptr<const GridSeries> grids;
  if (!options.grids.empty()) grids = std::make_shared<const GridSeries>(options.grids, 1);
  return {[=, speed = options.speed, column = options.column](
              const Mesh& mesh, const Moment& moment, const Progress&) {
    std::vector<Vec3> speeds(mesh.positions.size(), Vec3::UnitX());
    if (grids) speeds = sampled(*grids, mesh, moment.time, *counts);
    if (column) apply_mask(mesh, *column, speeds);
    std::vector<double> factors(speeds.size());
    for (std::size_t v = 0; v < factors.size(); ++v) factors[v] = speed * speeds[v].x();
    return huygens_velocities(mesh, factors);
  }};
}

Motion motion_of(const std::string& name, const FlowOptions& options,
                 const std::shared_ptr<FlowCounts>& counts) {
  if (name == "grid") return grid_motion(options, counts);
  if (name == "normal") return normal_motion(options, counts);
  if (const AnalyticField field = analytic_field(name, options))
    return analytic_motion(field, options.speed);
  if (!(options.speed > 0))
    throw UsageError("the speed of the flow '" + name + "' must be above 0");
  return curvature_flow(name, options.speed, [counts](std::size_t fixed) {
    counts->fixed = std::max(counts->fixed, fixed);
  });
}

}  // namespace

const std::vector<FlowKind>& flow_kinds() {
  static const std::vector<FlowKind> kinds{
      {"rotation", "rotation about an axis (Zalesak)", {"period", "center", "direction"}},
      {"vortex", "single vortex in the unit cube, reversing", {"period"}},
      {"deformation", "vortices in the unit cube, reversing (Enright, LeVeque)", {"period"}},
      {"abc", "chaotic flow of Arnold, Beltrami and Childress in the unit cube", {}},
      {"shear", "simple shear along x", {"center"}},
      {"expansion", "growth away from a center", {"center"}},
      {"translation", "motion along a direction", {"direction"}},
      {"grid", "velocities of a file, trilinear in space and linear in time", {"grid"}},
      {"normal", "growth or erosion along the normals", {"column", "grid"}},
      {"mean-curvature", "smoothing by the mean curvature; spheres shrink", {}},
      {"volume-preserving-curvature",
       "smoothing by the mean curvature at constant volume of each component",
       {}},
      {"surface-diffusion", "smoothing of fourth order at constant volume", {}}};
  return kinds;
}

Flow make_flow(const std::string& name, FlowOptions options) {
  check(kind_of(name), options);
  const auto counts = std::make_shared<FlowCounts>();
  return {motion_of(name, options, counts), counts};
}

}  // namespace transformesh
