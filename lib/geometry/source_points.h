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

#include "transformesh/carry.h"

namespace transformesh {

/// Returns the place on a face that is nearest to the point.
SourcePoint source_point_on(const Mesh& source, Index face, const Vec3& point);

/// Returns the position of a place on the source.
Vec3 position_of(const Mesh& source, const SourcePoint& place);

/// True if vertices and faces have the columns.
bool has_source_points(const Mesh& mesh);

}  // namespace transformesh
