/// What rounding of exact points to stored coordinates breaks (paper 4.3), and means to mend it:
/// close vertices merge, or go to a grid. When they are used says snap_rounding.h.
#pragma once

#include <vector>

#include "tm/clean/stitch/assemble.h"

namespace transformesh {

/// Faces that intersect a new face, or have no area, in the coordinates as they are; ascending.
/// Whole input faces are known not to intersect each other.
std::vector<Index> find_broken_faces(const Assembly& assembly);

/// The faces that are no whole faces of the input; ascending.
std::vector<Index> find_new_faces(const Assembly& assembly);

/// The faces, and all others that have a corner in common with them; ascending.
std::vector<Index> with_faces_around(const Mesh& mesh, const std::vector<Index>& faces);

/// Moves new vertices of the faces that are this close to other vertices of them to the position of
/// those, as snap_positions does. Input vertices stay, and attract new ones.
void merge_close_vertices(Assembly& assembly, const std::vector<Index>& faces, double distance);

/// Moves the new vertices of each cluster (clusters.h) near the faces to one position: to the
/// nearest input vertex of the cluster if there is one, else to the vertex nearest to its center.
void merge_clusters(Assembly& assembly, const std::vector<Index>& faces, Scalar coordinate);

/// The mesh with the vertices of marked faces on a grid, together with all vertices at the same
/// positions. Positions within a small part of the spacing of each other go to one grid point.
Mesh snap_to_grid(const Mesh& mesh, const std::vector<char>& marked_faces, double spacing,
                  Scalar coordinate);

}  // namespace transformesh
