/// Ambient occlusion: the fraction of the ambient light that reaches the surface at each vertex.
/// Reference: Zhukov, Iones & Kronin, "An ambient light illumination model", Rendering Techniques
/// 1998.
///
/// From each vertex, rays are cast in 128 directions, which are evenly distributed over the sphere
/// and the same in every run. Only directions on the outer side of the surface count, weighted by
/// the cosine to the area-weighted vertex normal. The openness of a vertex is the weighted fraction
/// of the rays that meet no face. The openness is 1 on convex bodies and at vertices without
/// normal, and 0 inside closed bodies. Faces at the vertex itself, and faces nearer than 1e-5 of
/// the diagonal of the bounding box, do not count.
///
/// Cost: one Bvh per direction, O(vertices log faces) if few boxes overlap. Parallel; the result
/// does not depend on the number of threads.
#pragma once

#include <string>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Writes openness to the vertex column of this name, as floats.
void set_openness(Mesh& mesh, const std::string& column, const Progress& progress = {});

}  // namespace transformesh
