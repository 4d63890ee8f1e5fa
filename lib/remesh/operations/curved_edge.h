/// Points on the smooth surface that a mesh samples, between its vertices.
///
/// The surface beside an edge is a height field z(x, y) over the plane that lies between its two
/// faces. The height is the quadric through both ends that fits the vertices around them best.
/// Reference: Cazals & Pouget, "Estimating differential quantities using polynomial fitting of
/// osculating jets", Computer Aided Geometric Design 2005. The quadric needs no vertex normals,
/// unlike curved PN triangles (Vlachos, Peters, Boyd & Mitchell, I3D 2001).
///
/// Vertices beyond a crease do not count. A crease is a border, a feature, or an edge that turns by
/// more than 40 degrees. Along a crease points lie on a cubic through its vertices.
#pragma once

#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

/// Returns the point of the surface at the middle of an edge. It is the midpoint of the chord if
/// the surface around is unknown or turns too much. O(valence).
Vec3 curved_midpoint(const EditableMesh& mesh, Index halfedge);

/// Returns the point of the surface above `target`. The target lies near the vertex, in the plane
/// perpendicular to its area normal. Returns `target` itself beside a crease. O(valence).
Vec3 lifted_onto_surface(const EditableMesh& mesh, Index vertex, const Vec3& target);

}  // namespace transformesh
