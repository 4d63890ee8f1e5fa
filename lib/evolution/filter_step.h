/// The step of an evolution (paper 5.1) made by anything that turns the bytes of a mesh into those
/// of another: a filter in any language. The mesh goes in as binary PLY. Where vertices of the mesh
/// that comes out lie elsewhere, they have moved there; else its vertex columns vx, vy and vz are
/// velocities, along which displace() moves them. Other columns that come out are carried on, so
/// that a filter may keep a state of its own at the vertices.
///
/// Throws InputError for what is no mesh, and for one with other vertices or faces: cleaning and
/// remeshing are the loop's; and what the filter throws. Cost: O(n) beside the filter's.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "transformesh/iteration.h"

namespace transformesh {

using MeshFilter = std::function<std::string(const std::string& bytes)>;

/// Meshes go in with coordinates of the type given.
Step step_through(MeshFilter filter, Scalar coordinate, const DisplaceOptions& options = {});

/// Returns the mesh as binary PLY with double coordinates, for a filter that computes velocities.
std::string bytes_for_filter(const Mesh& mesh);

/// Returns the velocities vx, vy and vz of a mesh in bytes. Throws InputError if they are missing.
std::vector<Vec3> velocities_in(const std::string& bytes);

}  // namespace transformesh
