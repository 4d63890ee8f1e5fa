/// Flows whose velocity follows from the curvature of the surface. Steps are semi-implicit, stable
/// for any span, and of second order in the span. H is the sum of the principal curvatures, and N
/// is the normal.
///
///     mean-curvature              -H N; a sphere has r(t)^2 = r(0)^2 - 4 t
///     volume-preserving-curvature (mean of H - H) N, for each component
///     surface-diffusion           (Laplacian of H) N, which keeps the volume of each component
///
/// Borders do not move. A component that would vanish within the span becomes tiny, and its
/// orientation may be reversed. The equations of a step are linear, because cotangents, areas and
/// normals are fixed during the step: they are those of the surface in the middle of the span. Two
/// shorter computations predict that surface. On a shrinking sphere of radius r the relative error
/// of a short step is 0.4 (span / r^2)^3. Reference for linear equations of mean-curvature flow:
/// Desbrun, Meyer, Schroeder & Barr, "Implicit fairing of irregular meshes using diffusion and
/// curvature flow", SIGGRAPH 1999. For steps around the middle of a span: Hairer, Norsett & Wanner,
/// "Solving ordinary differential equations I", 1993, section II.7. For constant volume: Huisken,
/// "The volume preserving mean curvature flow", Journal fuer die reine und angewandte Mathematik
/// 382, 1987. For curvature and velocity as separate unknowns: Baensch, Morin & Nochetto, "A finite
/// element method for surface diffusion: the parametric case", Journal of Computational Physics
/// 203, 2005.
#pragma once

#include <functional>
#include <string_view>

#include "transformesh/flow.h"

namespace transformesh {

/// Function that is called with the number of border vertices, which do not move.
using FixedCounter = std::function<void(std::size_t)>;

/// Returns the flow of this name, multiplied by `speed`. If there is no such flow, the result is a
/// Motion without functions. Its functions throw InputError for coincident borders, and for open
/// meshes if the flow keeps the volume. They throw GoalError if the equations have no solution in
/// double precision.
Motion curvature_flow(std::string_view name, double speed, const FixedCounter& fixed);

}  // namespace transformesh
