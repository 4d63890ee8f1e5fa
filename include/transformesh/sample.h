/// A surface as points with normals and columns: a number of them by area, or a Poisson disk, in
/// which no two are nearer than a distance and no other would fit.
///
/// Points have the unit normal of their face in the vertex columns nx ny nz (zero where the face
/// has none), the columns of the vertices, interpolated, and those of the faces, where no vertex
/// column has the name; corner lists are dropped. Distances are straight, through the inside too.
/// Floating point; deterministic in mesh, options and seed.
///
/// Reference: Cline, Jeschke, White, Razdan & Wonka, "Dart throwing on surfaces", Computer Graphics
/// Forum 28(4), 2009: darts, then parts of faces that no disk covers are split until none is left.
/// Nothing is left over: the disks of such a sampling, of half the distance, cover .55 of a plane,
/// .60 of what the densest packing has (Renyi's random sequential addition).
/// Cost: O(n + count); of a Poisson disk O(n + points), about .02 ms a point.
#pragma once

#include <cstdint>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct SampleOptions {
  std::size_t count = 0;  ///< points by area, as surface_samples() spreads them
  double distance = 0;    ///< > 0: instead a Poisson disk; input units
  std::uint64_t seed = 1;
};

/// A mesh without faces, points in the order of the faces where they are by area. Of a Poisson disk
/// no place of the surface is farther than the distance from a point, but for rounding and 1e-9 of
/// it. Throws InputError where the surface has no area or one that no double holds, UsageError
/// where neither or both are asked for, and where a Poisson disk would have more than 1e8 points.
Mesh sample_surface(const Mesh& mesh, const SampleOptions& options, const Progress& progress = {});

}  // namespace transformesh
