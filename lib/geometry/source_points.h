/// Source points: for each vertex and face of a mesh, the place on another mesh (the source) from
/// which it comes. A source point is a face of the source with barycentric coordinates. The columns
/// are source_face (int), source_u and source_v (double). The place is (1 - u - v) a + u b + v c,
/// where a, b and c are the corners of the face in their order. Faces are numbered from 0; polygons
/// count as the triangles into which they are read. A vertex column contains the place of the
/// vertex, a face column the place of the face's centroid.
///
/// Each vertex and face has a source point. A source point at a vertex of the source is exact. If a
/// vertex comes from an edge, or if several faces are equally close, its source point is on the
/// face with the lowest index. Therefore the place of a face cannot be derived from the source
/// points of its vertices, which may all be on edges of the source. Floating point; deterministic
/// for any number of threads. Cost: O(log n) per vertex and face for closest points.
#pragma once

#include "transformesh/carry.h"

namespace transformesh {

/// Returns the point of a source face that is nearest to the given point, with its barycentric
/// coordinates.
SourcePoint source_point_on(const Mesh& source, Index face, const Vec3& point);

Vec3 position_of(const Mesh& source, const SourcePoint& place);

/// True if both vertices and faces have the columns source_face, source_u and source_v.
bool has_source_points(const Mesh& mesh);

/// Returns the source points of a mesh whose faces are cut from faces of the source.
/// `face_sources[f]` is the source face from which face f is cut. Exact up to rounding if no vertex
/// was moved.
SourcePoints source_points_of_pieces(const Mesh& source, const Mesh& mesh,
                                     std::span<const double> face_sources);

/// Reads the columns source_face, source_u and source_v of vertices and faces. Throws InputError if
/// columns are missing, if a face index is not below `source_faces`, or if u or v is not in [0, 1].
/// The error for values names `source_name`.
SourcePoints read_source_points(const Mesh& mesh, std::size_t source_faces,
                                const std::string& source_name);

/// Converts source points (faces with barycentric coordinates) on `middle` to source points on
/// `first`. `middle_on_first` has the source points of the vertices and faces of `middle`. Exact at
/// vertices of `middle`; elsewhere the error is about edge^2 / radius of curvature.
SourcePoints compose_source_points(const Mesh& first, const SourcePoints& middle_on_first,
                                   const Mesh& middle, const SourcePoints& on_middle);

/// Calls `change(mesh)`. If `is_wanted` is set, also stores the source point of each vertex and
/// face: the closest point on the mesh before the change.
template <typename Change>
auto change_with_source_points(bool is_wanted, Mesh& mesh, const Change& change) {
  Mesh before;
  if (is_wanted) before = {mesh.positions, mesh.faces, {}, {}};
  auto result = change(mesh);
  if (is_wanted) write_source_points(mesh, closest_source_points(before, mesh));
  return result;
}

}  // namespace transformesh
