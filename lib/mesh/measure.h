/// Sizes of a mesh: lengths in input units, angles in degrees. Degenerate faces count with area 0
/// and angle 0. Sums run in face order: the same result for any number of threads. Coordinates of
/// any size do; an area or volume that no double can hold is infinite.
#pragma once

#include <span>

#include "mesh/mesh.h"

namespace transformesh {

struct Box {
  Vec3 minimum = Vec3::Zero();
  Vec3 maximum = Vec3::Zero();
  double diagonal() const;
};

/// The vertices that faces use, in their order.
std::vector<Vec3> used_positions(const Mesh& mesh);

/// The box of all vertices that faces use; of all vertices where there is no face.
Box bounding_box(const Mesh& mesh);

double face_area(const Mesh& mesh, Index face);
/// Twice the area times the unit normal.
Vec3 face_normal(const Mesh& mesh, Index face);
double surface_area(const Mesh& mesh);
/// Enclosed volume with sign, by the divergence theorem; positive where faces look outwards.
double volume(const Mesh& mesh);

struct EdgeLengths {
  std::size_t count = 0;  ///< distinct edges
  double mean = 0;
  double minimum = 0;
  double maximum = 0;
};
EdgeLengths edge_lengths(const Mesh& mesh);

/// The same over the halfedges, which need no search: an edge of two faces counts twice.
struct HalfedgeLengths {
  double mean = 0;
  double maximum = 0;
  std::vector<double> vertex_mean;  ///< of the edges at each vertex; 0 where there is none
};
HalfedgeLengths halfedge_lengths(const Mesh& mesh);

struct Angles {
  double minimum_deg = 0;       ///< smallest angle of any face
  double minimum_mean_deg = 0;  ///< mean over faces of their smallest angle
};
Angles angles(const Mesh& mesh);

/// Unit normals per vertex, weighted by angle (Baerentzen & Aanaes 2005); zero where undefined.
std::vector<Vec3> vertex_normals(const Mesh& mesh);
/// The same for one vertex, given its faces in ascending order.
Vec3 vertex_normal(const Mesh& mesh, Index vertex, std::span<const Index> faces);

/// Share of interior vertices with six edges.
double valence_six_share(const Mesh& mesh);

}  // namespace transformesh
