/// Carries columns from a mesh to another mesh whose vertices and faces have source points. A
/// source point is the point on the first mesh that a vertex or a face center comes from. The
/// operations clean(), remesh() and decimate() drop source points; these functions recompute them.
/// O(n log n); deterministic.
///
/// Numeric vertex columns are interpolated in the face of the source point. Face columns take the
/// row of that face. Texture coordinates are interpolated at the source point of each corner. At a
/// texture seam, the side of the face's source point is used.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// The point (1 - u - v) a + u b + v c on a face with the corners a, b and c.
struct SourcePoint {
  Index face = 0;
  double u = 0, v = 0;
  std::array<double, 3> weights() const { return {1 - u - v, u, v}; }
};

struct SourcePoints {
  std::vector<SourcePoint> of_vertices;
  std::vector<SourcePoint> of_faces;  ///< source points of face centers
};

/// Returns the closest points of a nearby source, on faces whose normals differ by less than 90
/// degrees. Throws InputError without source faces, and for extents below 1e-75 or above 1e75.
SourcePoints closest_source_points(const Mesh& source, const Mesh& mesh);

/// Writes the columns source_face, source_u and source_v of vertices and faces.
void write_source_points(Mesh& mesh, const SourcePoints& places);

struct CarryResult {
  std::size_t vertex_columns = 0, face_columns = 0;
};
/// Carries the columns `names`, or all except normals and source points if `names` is empty. Throws
/// InputError if the first mesh does not have a column of that name.
CarryResult carry_columns(const Mesh& first, const SourcePoints& on_first, Mesh& mesh,
                          const std::vector<std::string>& names = {});

struct CarryOptions {
  std::vector<std::string> columns;  ///< names of columns to carry; empty: as in carry_columns()
  bool closest = false;              ///< use the closest points for meshes without source points
  std::vector<std::string> names;    ///< names of the meshes, for messages; may be empty
};

/// Carries columns along a chain of meshes, each with source points on the mesh before it. `last`
/// is the last mesh of the chain; it gets the columns, and source points on the first mesh. Throws
/// InputError (no_source_points) if a mesh has no source points, unless `closest` is set.
CarryResult carry_along(std::span<const Mesh* const> before, Mesh& last,
                        const CarryOptions& options = {});

}  // namespace transformesh
