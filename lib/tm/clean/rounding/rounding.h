/// What rounding of exact points to stored coordinates breaks, and the means to mend it: close
/// vertices merge, or go to a grid (settle.h).
#pragma once

#include <vector>

#include "tm/clean/stitch/assemble.h"

namespace transformesh {

/// Faces that take part in a crossing with a new face, or have no area, in the coordinates as they
/// are. Whole input faces do not cross each other.
std::vector<Index> find_broken_faces(const Assembly& assembly);

/// The spacing of floats (or doubles) at the mesh's largest coordinate times 2^doublings.
double merge_distance(const Mesh& mesh, Scalar coordinate, int doublings);

std::vector<Index> find_new_faces(const Assembly& assembly);

/// The faces, and all at their corners.
std::vector<Index> with_faces_around(const Mesh& mesh, const std::vector<Index>& faces);

/// Gives new vertices of the faces that are this close to others the position of those: that of an
/// input vertex where there is one. Input vertices stay.
void merge_close_vertices(Assembly& assembly, const std::vector<Index>& faces, double distance);

/// Gives the new vertices of each crowd (crowds.h) near the faces one position: that of the input
/// vertex in it that is nearest, if there is one, else that of the one nearest to its middle.
void merge_crowds(Assembly& assembly, const std::vector<Index>& faces, Scalar coordinate);

/// The mesh with the vertices of marked faces on a grid, and what is at their positions too. Those
/// that are within a small part of the spacing of each other go to the same place.
Mesh snap_to_grid(const Mesh& mesh, const std::vector<char>& marked_faces, double spacing,
                  Scalar coordinate);

}  // namespace transformesh
