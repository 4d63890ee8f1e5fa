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

/// For a mesh whose faces are pieces of faces of the source, `face_sources[f]` being the face that
/// face f is cut from. Exact up to rounding if no vertex was moved.
SourcePoints source_points_of_pieces(const Mesh& source, const Mesh& mesh,
                                     std::span<const double> face_sources);

/// For a mesh that lies near the source: the closest places on faces whose normals differ by less
/// than a right angle. Throws InputError if the source has no faces.
SourcePoints closest_source_points(const Mesh& source, const Mesh& mesh);

/// Reads the columns source_face, source_u and source_v of vertices and faces. Throws InputError,
/// with `source_name`, if they are missing or name a face beyond `source_faces`.
SourcePoints read_source_points(const Mesh& mesh, std::size_t source_faces,
                                const std::string& source_name);
void write_source_points(Mesh& mesh, const SourcePoints& places);

/// Converts source points on `middle`, which has the source points `middle_on_first`, to source
/// points on `first`. Exact at vertices of `middle`; otherwise off by edge^2 / radius of curvature.
SourcePoints compose_source_points(const Mesh& first, const SourcePoints& middle_on_first,
                                   const Mesh& middle, const SourcePoints& on_middle);

struct CarryResult {
  std::size_t vertex_columns = 0, face_columns = 0;
};
/// Carries the columns `names`; empty: all but normals and source points. Throws InputError for a
/// name that the first mesh does not have.
CarryResult carry_columns(const Mesh& first, const SourcePoints& on_first, Mesh& mesh,
                          const std::vector<std::string>& names = {});

}  // namespace transformesh
