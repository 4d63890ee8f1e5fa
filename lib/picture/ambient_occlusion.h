/// Ambient occlusion: how much of the light from all around reaches the surface at each vertex.
///
/// From each vertex rays go in 128 directions, the same on every run, spread evenly over the
/// sphere; those on the outer side of the surface count by the cosine to the normal, the mean of
/// the normals of the faces weighted by area. The share that meets no face is the openness: 1
/// everywhere on convex bodies, 0 inside closed ones, 1 where there is no normal. Faces at the
/// vertex itself, and what is nearer than 1e-5 of the box's diagonal, block nothing. Reference:
/// Zhukov, Iones & Kronin, "An ambient light illumination model", Rendering Techniques 1998. Cost:
/// a Bvh for each direction, O(vertices log faces) if few boxes overlap; parallel; the same for any
/// number of threads.
#pragma once

#include <string>

#include "mesh/mesh.h"
#include "support/progress.h"

namespace transformesh {

/// Sets the vertex column of that name, of floats.
void set_openness(Mesh& mesh, const std::string& column, const Progress& progress = {});

}  // namespace transformesh
