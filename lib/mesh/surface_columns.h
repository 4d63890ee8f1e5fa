/// Columns that describe the surface where it stands, and so go stale where it changes: normals
/// (the numbers nx ny nz of vertices or faces), corner lists (texture coordinates of faces:
/// floating-point list columns with `tex` or `uv` in their names, which hold as many values for
/// each corner, in the order of the corners), and source points (where vertices and faces come
/// from: geometry/source_points.h). Cost: O(n), nothing without such columns.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Computes normals anew, weighted by angle, unless they are undefined. Returns whether any are.
bool refresh_normals(Mesh& mesh);

/// Turns normals the other way, as all faces were.
void reverse_normals(Mesh& mesh);

/// Exchanges what corner lists have for the last two corners of a face.
void reverse_corner_lists(Mesh& mesh, Index face);

/// Turns all faces around, with their normals and corner lists.
void reverse_faces(Mesh& mesh);

bool is_corner_list(const Column& column);

/// For faces that are no longer the same: erases corner lists, and returns their names.
std::vector<std::string> drop_corner_lists(Columns& face_columns);

/// The columns of source points, in this order.
inline constexpr std::array<const char*, 3> source_point_names{"source_face", "source_u",
                                                               "source_v"};

/// True if all three are there, as numbers.
bool has_source_columns(const Columns& columns);

/// Erases source points, as vertices or faces are no longer the same. Returns whether any were.
bool drop_source_points(Mesh& mesh);

/// A triangle that a polygon was cut into: the polygon's row and number of corners, and which of
/// them the triangle has.
struct PolygonTriangle {
  std::uint32_t row = 0;
  std::uint32_t size = 3;
  std::array<std::uint32_t, 3> corners{0, 1, 2};
};

/// After polygons were cut into triangles, whose rows have the whole lists of their polygon: leaves
/// each triangle the values of its three corners. Lists that do not have as many values for each
/// corner of the polygon stay.
void split_corner_lists(Columns& face_columns, std::span<const PolygonTriangle> triangles);

/// All of it, after faces were made or moved.
inline StaleColumns refresh_columns(Mesh& mesh) {
  return {refresh_normals(mesh), drop_corner_lists(mesh.face_columns), drop_source_points(mesh)};
}

}  // namespace transformesh
