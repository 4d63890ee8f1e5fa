/// Columns that describe the surface and become stale if the surface changes. Normals are the
/// columns nx ny nz of vertices or faces. Corner lists are the texture coordinates of faces. They
/// are floating-point list columns with `tex` or `uv` in their names, and have the same number of
/// values for each corner, in the order of the corners. Source points are described in
/// geometry/source_points.h. Cost: O(n), or nothing if there are no such columns.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Gives an integer column the type double, which holds the components of unit vectors.
void make_floating(Column& column);

/// Recomputes existing normals, weighted by angle. Normals that are undefined keep their old
/// values. Integer columns become doubles. Returns true if there are normals.
bool refresh_normals(Mesh& mesh);

/// Negates all normals. Call if all faces were reversed. Unsigned columns become doubles.
void reverse_normals(Mesh& mesh);

/// Exchanges the values of the last two corners of a face in columns with values per face corner,
/// such as texture coordinates.
void reverse_corner_lists(Mesh& mesh, Index face);

/// Reverses all faces, with their normals and their values per corner (texture coordinates).
void reverse_faces(Mesh& mesh);

bool is_corner_list(const Column& column);

/// Erases the columns with values per face corner (texture coordinates), and returns their names.
/// Call if faces have changed.
std::vector<std::string> drop_corner_lists(Columns& face_columns);

/// Names of the columns of source points: a face of another mesh and barycentric coordinates on it.
inline constexpr std::array<const char*, 3> source_point_names{"source_face", "source_u",
                                                               "source_v"};

/// True if all three columns of source points (places on another mesh) exist and are numbers.
bool has_source_columns(const Columns& columns);

/// Erases the columns of source points (places on another mesh). Returns true if the mesh had them.
/// Call if vertices or faces have changed.
bool drop_source_points(Mesh& mesh);

/// A triangle of a triangulated polygon: row and number of corners of the polygon, and the three
/// polygon corners of the triangle.
struct PolygonTriangle {
  std::uint32_t row = 0;
  std::uint32_t size = 3;
  std::array<std::uint32_t, 3> corners{0, 1, 2};
};

/// Shortens the corner lists of triangles. On entry, each triangle has the list of the whole
/// polygon; on return, it has the values of its three corners. A list whose length is not a
/// multiple of the polygon's number of corners is kept.
void split_corner_lists(Columns& face_columns, std::span<const PolygonTriangle> triangles);

/// Call after faces were created or moved. Recomputes normals, and erases texture coordinates of
/// corners and source points, because these are wrong afterwards.
inline StaleColumns refresh_columns(Mesh& mesh) {
  return {refresh_normals(mesh), drop_corner_lists(mesh.face_columns), drop_source_points(mesh)};
}

}  // namespace transformesh
