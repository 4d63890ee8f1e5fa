/// A rough closed mesh around points, such as a sparse reconstruction: an initial mesh for an
/// evolution, which need not have the right topology.
///
/// Points with normals: Poisson surface reconstruction (Kazhdan, Bolitho & Hoppe, SGP 2006; its
/// function by CGAL, its zero by marching tetrahedra). The surface goes between the points, and
/// closes gaps smoothly. Points alone: alpha wrapping (Portaneri, Rouxel-Labbe, Hemmer,
/// Cohen-Steiner & Alliez, TOG 41(4), 2022; by CGAL). The surface contains all points, its vertices
/// lie at the offset from them, and it goes where a ball of radius alpha can go. Faces are chords
/// between vertices, and so come nearer to the points than the offset, but never reach one.
#pragma once

#include <span>

#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct AlphaWrapOptions {
  double alpha = 0;   ///< > 0: radius of the smallest ball that is kept out; 0: see alpha_wrap
  double offset = 0;  ///< > 0: of vertices from the points; 0: a 300th of the box's diagonal
};

struct AlphaWrap {
  Mesh mesh;
  double alpha = 0;           ///< the one that was used
  double least_distance = 0;  ///< of a point from the surface; > 0
};

/// Closed, oriented 2-manifold that contains all points; one component where the points are dense
/// against alpha. An alpha of 0 stands for the smallest one down to a 100th of the box's diagonal,
/// in steps of 2^(1/4) from a fifth, that does not get in between the points: the next one would
/// leave it hollow, thinner than four offsets on more than a 20th of its area. Throws InputError
/// for no points, UsageError for options out of range and for an alpha that is to make more than
/// some million faces. Deterministic, one thread. Cost grows with the area by alpha^2: seconds for
/// a diagonal / 300, or where alpha is found among 10 000 points.
AlphaWrap alpha_wrap(std::span<const Vec3> points, const AlphaWrapOptions& options = {});

/// Closed, oriented 2-manifold without self-intersection, its edges about as long as the points are
/// apart. Normals point outwards; those that are zero are left out with their points. Throws
/// InputError for fewer than four points with normals and for points in a plane, GoalError where
/// most normals point inwards or do not agree; CGAL may say why on std::cerr, before that.
/// Deterministic; mostly one thread; a second for 10 000 points.
Mesh poisson_wrap(std::span<const Vec3> points, std::span<const Vec3> normals);

}  // namespace transformesh
