/// Measures of a mesh: lengths in input units, angles in degrees. Degenerate faces count with area
/// 0 and angle 0. Sums are in face order: the same result for any number of threads. Coordinates of
/// any size are allowed; an area or volume that no double can represent is infinite.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

using Box = Eigen::AlignedBox3d;

/// Returns the length of the diagonal; 0 for an empty box. Intermediate values do not overflow.
double diagonal_of(const Box& box);

/// Returns the box of all vertices that faces use, or of all vertices if there is no face. If there
/// is no vertex, both corners are the origin.
Box bounding_box(const Mesh& mesh);

/// Returns the area of one face; 0 if the face is degenerate.
double face_area(const Mesh& mesh, Index face);
/// Returns the unit normal times twice the area.
Vec3 face_normal(const Mesh& mesh, Index face);
/// Returns the sum of the areas of all faces.
double surface_area(const Mesh& mesh);
/// Signed enclosed volume, by the divergence theorem; positive for faces that are oriented
/// outwards.
double volume(const Mesh& mesh);

struct EdgeLengths {
  std::size_t count = 0;  ///< number of distinct edges
  double mean = 0;
  double minimum = 0;
  double maximum = 0;
};
EdgeLengths edge_lengths(const Mesh& mesh);

struct Angles {
  double minimum_deg = 0;       ///< smallest angle of any face
  double minimum_mean_deg = 0;  ///< mean of the smallest angles of all faces
};
Angles angles(const Mesh& mesh);

/// Returns unit normals of vertices, weighted by angle (Baerentzen & Aanaes 2005), zero if
/// undefined.
std::vector<Vec3> vertex_normals(const Mesh& mesh);

/// Fraction of interior vertices with six edges; [0, 1].
double valence_six_share(const Mesh& mesh);

}  // namespace transformesh
