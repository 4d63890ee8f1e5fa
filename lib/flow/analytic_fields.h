/// Velocity fields in closed form: standard test cases for methods that move surfaces. The vortex,
/// deformation and abc fields are meant for the unit cube, and are periodic outside of it.
///
/// Let s(x) be sin(pi x), S(x) be sin(2 pi x) and C(x) be cos(2 pi x).
///
///     rotation     2 pi / period * axis x (p - center)
///     vortex       (-s(x)^2 S(y), S(x) s(y)^2, 0) cos(pi t / period)
///     deformation  (2 s(x)^2 S(y) S(z), -S(x) s(y)^2 S(z), -S(x) S(y) s(z)^2) cos(pi t / period)
///     abc          (A S(z) + C C(y), B S(x) + A C(z), C S(y) + B C(x))
///     shear        (z - center.z, 0, 0)
///     expansion    p - center
///     translation  direction / |direction|
///
/// Reference for the rotation: Zalesak, "Fully multidimensional flux-corrected transport algorithms
/// for fluids", Journal of Computational Physics 31, 1979.
/// For the vortex: Bell, Colella & Glaz, "A second-order projection method for the incompressible
/// Navier-Stokes equations", Journal of Computational Physics 85, 1989.
/// For the deformation, and the cosine that takes particles back: LeVeque, "High-resolution
/// conservative algorithms for advection in incompressible flow", SIAM Journal on Numerical
/// Analysis 33, 1996.
/// For its period of 3: Enright, Fedkiw, Ferziger & Mitchell, "A hybrid particle level set method
/// for improved interface capturing", Journal of Computational Physics 183, 2002.
/// For abc: Dombre et al., "Chaotic streamlines in the ABC flows", Journal of Fluid Mechanics 167,
/// 1986.
#pragma once

#include <functional>
#include <string_view>

#include "transformesh/flow.h"

namespace transformesh {

/// Function that returns the velocity at a point.
using VectorAt = std::function<Vec3(const Vec3& point)>;
/// Function that returns the velocity field at a point in time.
using AnalyticField = std::function<VectorAt(double time)>;

/// Returns the velocity field of this name, or null if there is none. Ignores `options.speed`.
AnalyticField analytic_field(std::string_view name, const FlowOptions& options);

}  // namespace transformesh
