/// A rough closed mesh around points, such as a sparse reconstruction, to start an evolution from.
/// Its topology may differ from that of the scanned object.
///
/// Points with normals: Poisson surface reconstruction (Kazhdan, Bolitho & Hoppe, "Poisson surface
/// reconstruction", SGP 2006), with the function of CGAL and its zero set by marching tetrahedra.
/// The surface passes between the points, and closes gaps smoothly. Points alone: alpha wrapping
/// (Portaneri, Rouxel-Labbe, Hemmer, Cohen-Steiner & Alliez, "Alpha wrapping with an offset", TOG
/// 41(4), 2022) by CGAL. The surface contains all points, and its vertices lie at the offset from
/// them. It enters cavities that a ball of radius alpha can enter. Faces are chords between
/// vertices; they come nearer to the points than the offset, but never reach a point.
#pragma once

#include <span>

#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct AlphaWrapOptions {
  double alpha = 0;  ///< > 0: radius of the ball that stays outside; 0: see alpha_wrap()
  /// > 0: distance of vertices from the points. 0: an eighth of the points' spacing, at most 1/300
  /// of the diagonal of the bounding box.
  double offset = 0;
};

struct AlphaWrap {
  Mesh mesh;
  double alpha = 0;           ///< alpha that was used
  double least_distance = 0;  ///< least distance of a point from the surface; > 0
  double offset = 0;          ///< offset that was used
};

/// Returns a closed, oriented 2-manifold that contains all points; one component if the points are
/// dense compared with alpha. With alpha 0, alpha decreases from 1/5 of the bounding box's diagonal
/// in steps of 2^(1/4), at most to 1/100, until a wrap would be hollow. The ball then gets in
/// between the points. A wrap is hollow if more than 1/20 of its area is thinner than four offsets,
/// or, with the default offset, than 1/75 of the diagonal. Throws InputError if there are no
/// points, and UsageError for options out of range and for an alpha that would give more than two
/// million faces. Deterministic, one thread. Cost grows with the area over alpha^2: seconds for
/// alpha = diagonal / 300, or to find alpha among 10 000 points.
AlphaWrap alpha_wrap(std::span<const Vec3> points, const AlphaWrapOptions& options = {});

/// Returns a closed, oriented 2-manifold without self-intersection. Its edges are about as long as
/// the spacing of the points. Normals point outwards; points with a zero normal are left out.
/// Throws InputError for fewer than four points with normals and for coplanar points. Throws
/// GoalError if most normals point inwards or disagree; before that CGAL may print the reason to
/// std::cerr. Deterministic; mostly one thread; 1 s for 10 000 points.
Mesh poisson_wrap(std::span<const Vec3> points, std::span<const Vec3> normals);

}  // namespace transformesh
