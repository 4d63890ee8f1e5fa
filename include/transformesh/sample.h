/// Samples a surface by points with normals and columns: a number of points uniform by area, or a
/// maximal Poisson-disk sampling. In a Poisson-disk sampling no two points are nearer than a given
/// distance, and no further point fits.
///
/// Points have the unit normal of their face in the vertex columns nx ny nz (zero if the face has
/// no normal). Points get the interpolated vertex columns, and the face columns whose names no
/// vertex column has. Texture coordinates are dropped. Distances are Euclidean, not geodesic.
/// Floating point; deterministic in mesh, options and seed.
///
/// Reference: Cline, Jeschke, White, Razdan & Wonka, "Dart throwing on surfaces", Computer Graphics
/// Forum 28(4), 2009. Random points are tried; then parts of faces that no disk covers are split
/// until none is left. Disks of half the distance cover .55 of a plane, .60 of the densest packing
/// (Renyi's random sequential addition). Cost: O(n + count); Poisson disk: O(n + points), about .02
/// ms per point, unless faces are longer than the distance. The sum of such lengths divided by the
/// distance is added: about .01 ms each.
#pragma once

#include <cstdint>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct SampleOptions {
  std::size_t count = 0;  ///< number of points uniform by area (surface_samples())
  double distance = 0;    ///< > 0: least distance of a Poisson-disk sampling; input units
  std::uint64_t seed = 1;
};

/// Returns a mesh without faces. Points by area are in the order of the faces. With a Poisson-disk
/// sampling no point of the surface is farther than the distance from a sample, up to rounding and
/// 1e-9 of the distance. Throws InputError if the area is 0 or exceeds the range of doubles. Throws
/// UsageError if neither or both of `count` and `distance` are set, and for more than 1e8
/// Poisson-disk points.
Mesh sample_surface(const Mesh& mesh, const SampleOptions& options, const Progress& progress = {});

}  // namespace transformesh
