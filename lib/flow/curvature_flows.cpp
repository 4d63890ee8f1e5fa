#include "flow/curvature_flows.h"

#include <optional>

#include "flow/conserved_volume.h"
#include "flow/diffusion_step.h"
#include "mesh/touching_borders.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Returns displacements from `start` over a span, or velocities if the span is 0. The unit of time
/// is such that the speed of the flow is 1. Cotangents, areas and normals are those of `shape`,
/// which has the connectivity of `start`.
using Vectors = std::vector<Vec3> (*)(const Mesh& start, const Mesh& shape,
                                      const DiffusionStep& step, double span);

std::vector<Vec3> mean_curvature(const Mesh& start, const Mesh&, const DiffusionStep& step,
                                 double span) {
  const std::vector<Vec3> rates = step.curvature_vectors(start.positions);
  return span > 0 ? step.second_order(span).after(rates) : rates;
}

/// Flows by mean curvature and then restores the volume by a movement along the normals. The
/// vectors of that movement are smoothed by the same diffusion equations as the surface.
std::vector<Vec3> volume_preserving(const Mesh& start, const Mesh& shape, const DiffusionStep& step,
                                    double span) {
  std::vector<Vec3> vectors = step.curvature_vectors(start.positions);
  if (!(span > 0)) {
    remove_volume_rates(start, vectors);
    return vectors;
  }
  const Relaxation equations = step.second_order(span);
  vectors = equations.after(vectors);
  restore_volumes(start, equations.after(vertex_normals(shape)), vectors);
  return vectors;
}

std::vector<Vec3> surface_diffusion(const Mesh& start, const Mesh& shape, const DiffusionStep& step,
                                    double span) {
  const std::vector<Vec3> normals = vertex_normals(shape);
  std::vector<double> offsets(normals.size());
  for (std::size_t v = 0; v < offsets.size(); ++v)
    offsets[v] = (shape.positions[v] - start.positions[v]).dot(normals[v]);
  std::vector<double> along = step.diffusion_speeds(offsets);
  if (span > 0) along = step.fourth_order(span).after(along);
  std::vector<Vec3> vectors(normals.size());
  for (std::size_t v = 0; v < vectors.size(); ++v) vectors[v] = along[v] * normals[v];
  if (span > 0)
    restore_volumes(start, normals, vectors);
  else
    remove_volume_rates(start, vectors);
  return vectors;
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

Mesh moved_by(Mesh mesh, const std::vector<Vec3>& displacements, double factor) {
  for (std::size_t v = 0; v < displacements.size(); ++v)
    mesh.positions[v] += factor * displacements[v];
  return mesh;
}

/// Returns the displacements by the implicit midpoint rule. The equations of the flow are linear if
/// cotangents, areas and normals are fixed. Here they are those of the surface in the middle of the
/// span. A step over half of the span predicts that surface. The step over the whole span from the
/// predicted surface corrects it once. The predicted surface alone gives order 2 as well, but on a
/// shrinking sphere 16 times the error.
std::vector<Vec3> integrated(const Mesh& start, const DiffusionStep& first,
                             const CurvatureFlow& flow, double span) {
  const auto around = [&](const Mesh& shape, double length) {
    return flow.vectors(start, shape, DiffusionStep(shape), length);
  };
  const Mesh predicted = moved_by(start, flow.vectors(start, start, first, span / 2), 1);
  const Mesh middle = moved_by(start, around(predicted, span), 0.5);
  return around(middle, span);
}

}  // namespace

Motion curvature_flow(std::string_view name, double speed, const FixedCounter& fixed) {
  const std::optional<CurvatureFlow> flow = flow_of(name);
  if (!flow) return {};
  const auto check = [=](const Mesh& mesh) {
    refuse_touching_borders(mesh);
    if (flow->keeps_volume) require_volume(mesh);
  };
  return {[=](const Mesh& mesh, const Moment&, const Progress&) {
            check(mesh);
            const DiffusionStep step(mesh);
            fixed(step.border_count());
            std::vector<Vec3> velocities = flow->vectors(mesh, mesh, step, 0);
            for (Vec3& velocity : velocities) velocity *= speed;
            return velocities;
          },
          [=](const Mesh& mesh, const Moment& moment, const Progress&) {
            check(mesh);
            const DiffusionStep step(mesh);
            fixed(step.border_count());
            return integrated(mesh, step, *flow, speed * moment.span);
          }};
}

}  // namespace transformesh
