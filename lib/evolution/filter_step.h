/// The step of an evolution (paper 5.1), made by an external filter that reads a mesh and writes
/// one, in any language. The filter reads binary PLY. If it changes positions, these are the new
/// positions. Otherwise, if its output has the vertex columns vx, vy and vz, displace() moves the
/// vertices at these velocities. Other columns of the output are kept, so that a filter can store a
/// state at the vertices.
///
/// Throws InputError if the output is not a mesh or has other vertices or faces; cleaning and
/// remeshing are done by the loop. Exceptions of the filter pass through. Cost: O(n) plus the
/// filter's.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "transformesh/iteration.h"

namespace transformesh {

using MeshFilter = std::function<std::string(const std::string& bytes)>;

/// Returns a step that calls the filter. `coordinate` is the type of the coordinates in its input.
Step step_through(MeshFilter filter, Scalar coordinate, const DisplaceOptions& options = {});

/// Returns the mesh as binary PLY with double coordinates, for a filter that computes velocities.
std::string bytes_for_filter(const Mesh& mesh);

/// Reads a mesh and returns its velocities vx, vy and vz. Throws InputError if they are missing.
std::vector<Vec3> velocities_in(const std::string& bytes);

}  // namespace transformesh
