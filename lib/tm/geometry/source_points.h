/// Where on another mesh, the source, the vertices of a mesh come from: a face of the source and
/// barycentric coordinates in it. As vertex columns these are source_face (int), source_u and
/// source_v (double): the place is (1 - u - v) a + u b + v c, a, b and c being the corners of the
/// face in their order. Faces are numbered from 0, polygons as the triangles that they are read as.
///
/// Every vertex gets a place. At a vertex of the source it is that vertex exactly; along an edge,
/// and of faces as near, the lowest face is named. Floating point; deterministic for any number of
/// threads.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

struct SourcePoint {
  Index face = 0;
  double u = 0;  ///< share of the second corner
  double v = 0;  ///< share of the third
  std::array<double, 3> weights() const { return {1 - u - v, u, v}; }
};

/// The place on a face that is nearest to the point.
SourcePoint source_point_on(const Mesh& source, Index face, const Vec3& point);
Vec3 position_of(const Mesh& source, const SourcePoint& place);

/// For a mesh whose faces are pieces of faces of the source: `face_sources` has, for each face, the
/// number of the one that it is cut from. The nearest place on the faces that a vertex's own faces
/// are cut from: exact up to rounding where nothing was moved. O(n).
std::vector<SourcePoint> source_points_of_pieces(const Mesh& source, const Mesh& mesh,
                                                 std::span<const double> face_sources);

/// For a mesh that lies near the source: the closest place, of those faces that look the way the
/// vertex does, within a right angle, so that no vertex goes to the other side of a thin sheet.
/// O(n log n). Throws InputError where the source has no faces.
std::vector<SourcePoint> closest_source_points(const Mesh& source, const Mesh& mesh);

bool has_source_points(const Mesh& mesh);
/// Throws InputError where the columns are missing or name what the source, a mesh with so many
/// faces that messages call `source_name`, does not have.
std::vector<SourcePoint> read_source_points(const Mesh& mesh, std::size_t source_faces,
                                            const std::string& source_name);
/// Writes the columns, in the place of those that there are.
void write_source_points(Mesh& mesh, std::span<const SourcePoint> places);

}  // namespace transformesh
