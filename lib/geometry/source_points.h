/// Places on another mesh, the source, that the vertices and the faces of a mesh come from: a face
/// of the source and barycentric coordinates in it. As columns these are source_face (int),
/// source_u and source_v (double): the place is (1 - u - v) a + u b + v c, a, b and c being the
/// corners of the face in their order. Faces are numbered from 0, polygons as the triangles that
/// they are read as. A vertex column names the place of the vertex, a face column that of the
/// middle of the face.
///
/// Every vertex and face gets a place. At a vertex of the source it is that vertex exactly; along
/// an edge, and of faces as near, a vertex names the lowest face. The place of a face therefore
/// cannot be derived from those of its vertices, which may all lie on edges of the source.
/// Floating point; deterministic for any number of threads.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace transformesh {

struct SourcePoint {
  Index face = 0;
  double u = 0;  ///< share of the second corner
  double v = 0;  ///< share of the third
  std::array<double, 3> weights() const { return {1 - u - v, u, v}; }
};

struct SourcePoints {
  std::vector<SourcePoint> of_vertices;
  std::vector<SourcePoint> of_faces;  ///< of their middles
};

/// The place on a face that is nearest to the point.
SourcePoint source_point_on(const Mesh& source, Index face, const Vec3& point);
Vec3 position_of(const Mesh& source, const SourcePoint& place);

/// For a mesh whose faces are pieces of faces of the source: `face_sources` has, for each face, the
/// number of the one that it is cut from. A vertex gets the nearest place on the faces that its own
/// faces are cut from: exact up to rounding where nothing was moved. O(n).
SourcePoints source_points_of_pieces(const Mesh& source, const Mesh& mesh,
                                     std::span<const double> face_sources);

/// For a mesh that lies near the source: the closest places, of those faces that look the way the
/// vertex or the face does, within a right angle, so that nothing goes to the other side of a thin
/// sheet. O(n log n). Throws InputError where the source has no faces.
SourcePoints closest_source_points(const Mesh& source, const Mesh& mesh);

/// True if vertices and faces have the columns.
bool has_source_points(const Mesh& mesh);
/// Throws InputError where the columns are missing or name what the source, a mesh with so many
/// faces that messages call `source_name`, does not have.
SourcePoints read_source_points(const Mesh& mesh, std::size_t source_faces,
                                const std::string& source_name);
/// Writes the columns, in the place of those that there are.
void write_source_points(Mesh& mesh, const SourcePoints& places);

}  // namespace transformesh
