/// Carries columns from a mesh to another whose vertices and faces know where on it they come from
/// (source_points.h), also through meshes between the two.
///
/// Numbers of vertices are interpolated in the face that a vertex comes from, as documented in
/// columns.h; so each value is that of the first mesh at one place of it, and a chain blurs
/// nothing. Columns of faces take the row of the face that a face itself comes from, whatever its
/// vertices name. Lists of texture coordinates (surface_columns.h) get the values at the places of
/// the corners; a face whose corners come from both sides of a seam, where neighboring faces have
/// different values, stays on the side of its own place: corners beyond take the nearest place
/// there. Two faces that share no vertices have a seam between them. Deterministic. Cost: O(n log
/// n); of textures, as much as there are faces within reach of each face's corners.
#pragma once

#include <string>
#include <vector>

#include "geometry/source_points.h"
#include "mesh/mesh.h"

namespace transformesh {

/// The places on the first mesh of what has the places `on_middle` on a mesh between, which has the
/// places `middle_on_first`. Exact at vertices of the middle, and where a face of it and its
/// corners come from one face of the first. Elsewhere it is the place of the mean of the corners'
/// places on that face if the mean lies there, else the closest one on the side of the surface that
/// they are on: off by about the square of an edge over the radius of curvature.
SourcePoints compose_source_points(const Mesh& first, const SourcePoints& middle_on_first,
                                   const Mesh& middle, const SourcePoints& on_middle);

/// How many columns were carried.
struct CarryResult {
  std::size_t vertex_columns = 0;
  std::size_t face_columns = 0;
};

/// Columns named, of vertices and of faces, take the place of those with the same name; where
/// `names` is empty, all but the normals nx ny nz and source points. Throws InputError for a name
/// that the first mesh does not have.
CarryResult carry_columns(const Mesh& first, const SourcePoints& on_first, Mesh& mesh,
                          const std::vector<std::string>& names = {});

}  // namespace transformesh
