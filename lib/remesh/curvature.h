/// How strongly a triangulated surface bends.
#pragma once

#include <vector>

#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

/// The larger absolute principal curvature at every vertex (0 where there is none): that of the
/// tensor which sums angle times length over the edges of the faces up to two rings away, over
/// their area (Cohen-Steiner & Morvan, "Restricted Delaunay triangulations and normal cycle", SoCG
/// 2003). Borders and edges marked as features bend nothing. Converges on fine meshes; noise counts
/// as curvature. O(n); floating point; deterministic.
std::vector<double> largest_curvatures(const EditableMesh& mesh);

}  // namespace transformesh
