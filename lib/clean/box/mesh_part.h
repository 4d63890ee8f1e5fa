/// Parts of a large mesh, by boxes. Deterministic. Cost: O(n), a few bits a face.
#pragma once

#include <vector>

#include "mesh/measure.h"
#include "mesh/mesh.h"

namespace transformesh {

/// The faces whose first vertex is in the half-open box.
std::vector<bool> faces_of_box(const Mesh& mesh, const Box& box);

/// The box around faces; nothing is in it where there are none.
Box box_around(const Mesh& mesh, const std::vector<bool>& faces);

/// The faces that come as near to the box as `margin`, by their own boxes.
std::vector<bool> faces_near(const Mesh& mesh, const Box& box, double margin);

struct MeshPart {
  Mesh mesh;
  std::vector<Index> face_of;  ///< per face: that of the mesh
};

/// Vertices that are in the place of a used one come along, used or not: so the first vertex of
/// every place is the same as in the mesh. Order and columns stay.
MeshPart take_part(const Mesh& mesh, const std::vector<bool>& faces);

/// Whether every edge is traversed equally often in both directions, by positions; faces without
/// area do not count. Decided by sums of hashes: a mesh that is not closed passes by a chance of
/// 2^-64.
bool is_closed_chain(const Mesh& mesh);

}  // namespace transformesh
