#include "flow/curvature_flows.h"

#include <optional>

#include "flow/conserved_volume.h"
#include "flow/diffusion_step.h"
#include "mesh/touching_borders.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Returns displacements over a span, or velocities if the span is 0. The unit of time is such that
/// the speed of the flow is 1.
using Vectors = std::vector<Vec3> (*)(const Mesh& mesh, const DiffusionStep& step, double span);

std::vector<Vec3> mean_curvature(const Mesh&, const DiffusionStep& step, double span) {
  return span > 0 ? step.second_order(span) : step.curvature_vectors();
}

std::vector<Vec3> at_constant_volume(const Mesh& mesh, std::vector<Vec3> vectors, double span) {
  if (span > 0)
    restore_volumes(mesh, vectors);
  else
    remove_volume_rates(mesh, vectors);
  return vectors;
}

std::vector<Vec3> volume_preserving(const Mesh& mesh, const DiffusionStep& step, double span) {
  require_volume(mesh);
  return at_constant_volume(mesh, mean_curvature(mesh, step, span), span);
}

std::vector<Vec3> surface_diffusion(const Mesh& mesh, const DiffusionStep& step, double span) {
  require_volume(mesh);
  std::vector<Vec3> vectors = vertex_normals(mesh);
  const std::vector<double> speeds = step.fourth_order(span);
  for (std::size_t v = 0; v < vectors.size(); ++v) vectors[v] *= speeds[v] * (span > 0 ? span : 1);
  return at_constant_volume(mesh, std::move(vectors), span);
}

struct CurvatureFlow {
  Vectors vectors;
  bool keeps_volume;
};

std::optional<CurvatureFlow> flow_of(std::string_view name) {
  if (name == "mean-curvature") return CurvatureFlow{mean_curvature, false};
  if (name == "volume-preserving-curvature") return CurvatureFlow{volume_preserving, true};
  if (name == "surface-diffusion") return CurvatureFlow{surface_diffusion, true};
  return std::nullopt;
}

Mesh moved_by(Mesh mesh, const std::vector<Vec3>& displacements) {
  for (std::size_t v = 0; v < displacements.size(); ++v) mesh.positions[v] += displacements[v];
  return mesh;
}

/// Returns twice the displacements of two steps over half of the span, minus those of one step over
/// the whole span (Richardson extrapolation). The errors of first order cancel.
std::vector<Vec3> extrapolated(const Mesh& mesh, const DiffusionStep& step,
                               const CurvatureFlow& flow, double span) {
  const std::vector<Vec3> whole = flow.vectors(mesh, step, span);
  std::vector<Vec3> result = flow.vectors(mesh, step, span / 2);
  const Mesh middle = moved_by(mesh, result);
  const std::vector<Vec3> rest = flow.vectors(middle, DiffusionStep(middle), span / 2);
  for (std::size_t v = 0; v < result.size(); ++v) result[v] = 2 * (result[v] + rest[v]) - whole[v];
  if (flow.keeps_volume) restore_volumes(mesh, result);
  return result;
}

}  // namespace

Motion curvature_flow(std::string_view name, double speed, const FixedCounter& fixed) {
  const std::optional<CurvatureFlow> flow = flow_of(name);
  if (!flow) return {};
  const auto step_of = [=](const Mesh& mesh) {
    refuse_touching_borders(mesh);
    DiffusionStep step(mesh);
    fixed(step.border_count());
    return step;
  };
  return {[=](const Mesh& mesh, const Moment&, const Progress&) {
            std::vector<Vec3> velocities = flow->vectors(mesh, step_of(mesh), 0);
            for (Vec3& velocity : velocities) velocity *= speed;
            return velocities;
          },
          [=](const Mesh& mesh, const Moment& moment, const Progress&) {
            return extrapolated(mesh, step_of(mesh), *flow, speed * moment.span);
          }};
}

}  // namespace transformesh
