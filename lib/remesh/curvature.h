/// Estimates the curvature of a triangulated surface.
#pragma once

#include <vector>

#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

/// Returns for each vertex the largest absolute principal curvature; 0 for dead vertices. The
/// curvature is the spectral radius of a tensor: the sum over edges of dihedral angle times length,
/// divided by the area of the faces. Sums are over the faces of the vertex and of its neighbors.
/// Reference: Cohen-Steiner & Morvan, "Restricted Delaunay triangulations and normal cycle", SoCG
/// 2003. Borders and features do not contribute. The result converges on fine meshes; noise counts
/// as curvature. O(n); floating point; deterministic.
std::vector<double> largest_curvatures(const EditableMesh& mesh);

}  // namespace transformesh
