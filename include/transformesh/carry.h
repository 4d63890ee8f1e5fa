/// Carries columns from a mesh to another whose vertices and faces have source points: the places
/// on the first mesh that they come from. The operations clean(), remesh() and decimate() drop
/// source points; these functions make them afterwards. O(n log n); deterministic.
///
/// Numbers of vertices are interpolated in the face that a vertex comes from; columns of faces take
/// the row of the source point's face. A list of texture coordinates gets the values at the
/// corners; if they come from both sides of a seam, those of the side of the face's source point.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// The place (1 - u - v) a + u b + v c on a face with the corners a, b and c.
struct SourcePoint {
  Index face = 0;
  double u = 0, v = 0;
  std::array<double, 3> weights() const { return {1 - u - v, u, v}; }
};

struct SourcePoints {
  std::vector<SourcePoint> of_vertices;
  std::vector<SourcePoint> of_faces;  ///< source points of the middles of faces
};

/// For a mesh that lies near the source: the closest places on faces whose normals differ by less
/// than a right angle. Throws InputError if the source has no faces.
SourcePoints closest_source_points(const Mesh& source, const Mesh& mesh);

/// Writes the columns source_face, source_u and source_v of vertices and faces.
void write_source_points(Mesh& mesh, const SourcePoints& places);

struct CarryResult {
  std::size_t vertex_columns = 0, face_columns = 0;
};
/// Carries the columns `names`; empty: all but normals and source points. Throws InputError for a
/// name that the first mesh does not have.
CarryResult carry_columns(const Mesh& first, const SourcePoints& on_first, Mesh& mesh,
                          const std::vector<std::string>& names = {});

struct CarryOptions {
  std::vector<std::string> columns;  ///< names; empty: as of carry_columns()
  bool closest = false;              ///< meshes without source points take the closest places
  std::vector<std::string> names;    ///< names of the meshes, for messages; may be empty
};

/// Carries columns along a chain of meshes, each with source points on the one before. `last` is
/// the last mesh of the chain, which gets the columns and source points on the first mesh. Throws
/// InputError (no_source_points) if a mesh has no source points, unless `closest`.
CarryResult carry_along(std::span<const Mesh* const> before, Mesh& last,
                        const CarryOptions& options = {});

}  // namespace transformesh
