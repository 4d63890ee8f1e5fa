/// Submeshes of a large mesh that lie in or near a box. Deterministic. Cost: O(n), a few bits a
/// face.
#pragma once

#include <vector>

#include "transformesh/measure.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// The faces whose first vertex is in the half-open box.
std::vector<bool> faces_of_box(const Mesh& mesh, const Box& box);

/// The box around faces; nothing is in it where there are none.
Box box_around(const Mesh& mesh, const std::vector<bool>& faces);

/// The faces that come as near to the box as `margin`, by their own boxes.
std::vector<bool> faces_near(const Mesh& mesh, const Box& box, double margin);

/// Some faces of a mesh as a mesh of their own.
struct BoxSubmesh {
  Mesh mesh;
  std::vector<Index> face_of;  ///< index of each face in the whole mesh
};

/// Vertices that are in the place of a used one come along, used or not: so the first vertex of
/// every place is the same as in the mesh. Order and columns stay.
BoxSubmesh take_submesh(const Mesh& mesh, const std::vector<bool>& faces);

/// Whether every edge is traversed equally often in both directions, by positions; faces without
/// area do not count. Decided by sums of hashes: a mesh that is not closed passes by a chance of
/// 2^-64.
bool is_closed_chain(const Mesh& mesh);

}  // namespace transformesh
