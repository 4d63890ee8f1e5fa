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

/// For a mesh whose faces are pieces of faces of the source, `face_sources[f]` being the face that
/// face f is cut from. Exact up to rounding if no vertex was moved.
SourcePoints source_points_of_pieces(const Mesh& source, const Mesh& mesh,
                                     std::span<const double> face_sources);

/// Reads the columns source_face, source_u and source_v of vertices and faces. Throws InputError,
/// with `source_name`, if they are missing or name a face beyond `source_faces`.
SourcePoints read_source_points(const Mesh& mesh, std::size_t source_faces,
                                const std::string& source_name);

/// Converts source points on `middle`, which has the source points `middle_on_first`, to source
/// points on `first`. Exact at vertices of `middle`; otherwise off by edge^2 / radius of curvature.
SourcePoints compose_source_points(const Mesh& first, const SourcePoints& middle_on_first,
                                   const Mesh& middle, const SourcePoints& on_middle);

/// Calls `change(mesh)`. If `is_wanted`, afterwards writes source points: the closest places on the
/// mesh as it was.
template <typename Change>
auto change_with_source_points(bool is_wanted, Mesh& mesh, const Change& change) {
  Mesh before;
  if (is_wanted) before = {mesh.positions, mesh.faces, {}, {}};
  auto result = change(mesh);
  if (is_wanted) write_source_points(mesh, closest_source_points(before, mesh));
  return result;
}

}  // namespace transformesh
