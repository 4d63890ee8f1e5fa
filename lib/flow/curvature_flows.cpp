#include "flow/curvature_flows.h"

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

Vectors vectors_of(std::string_view name) {
  if (name == "mean-curvature") return mean_curvature;
  if (name == "volume-preserving-curvature") return volume_preserving;
  if (name == "surface-diffusion") return surface_diffusion;
  return nullptr;
}

}  // namespace

Motion curvature_flow(std::string_view name, double speed, const FixedCounter& fixed) {
  const Vectors vectors = vectors_of(name);
  if (vectors == nullptr) return {};
  const auto evaluate = [=](const Mesh& mesh, double span) {
    refuse_touching_borders(mesh);
    const DiffusionStep step(mesh);
    fixed(step.border_count());
    return vectors(mesh, step, span);
  };
  return {[=](const Mesh& mesh, const Moment&, const Progress&) {
            std::vector<Vec3> velocities = evaluate(mesh, 0);
            for (Vec3& velocity : velocities) velocity *= speed;
            return velocities;
          },
          [=](const Mesh& mesh, const Moment& moment, const Progress&) {
            return evaluate(mesh, speed * moment.span);
          }};
}

}  // namespace transformesh
