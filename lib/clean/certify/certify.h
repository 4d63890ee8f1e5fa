/// Verifies by sample points that the output is the boundary of { p : w(p) >= winding level } of
/// the input. At each sample the winding number of the output must be 1 if that of the input is >=
/// winding level, and 0 otherwise. Winding numbers are counted exactly along rays. A limited number
/// of them is compared with sums of solid angles. The cleaning code uses none of the functions that
/// verify its result.
///
/// A sample is a point in front of or behind a face, closer to it than to any other face of input
/// and output. Five kinds of faces are sampled, at most `most_faces` of each kind, evenly spread:
///
/// - new faces of the output, which are not faces of the input corner by corner;
/// - four faces of each uncut patch of the input: connected faces without intersections;
/// - the faces of the input that were cut;
/// - up to 2000 unchanged faces of the output, and up to 2000 removed faces of the input.
///
/// A sample is undecided if all tried points next to the face are too close to new or removed
/// faces. Too close means that rounding may have moved these faces across the point. The limit of
/// the distance along each axis is twice the spacing of numbers of type `coordinate` at the new or
/// removed face. For a new face, the limit is 4 times its measured distance from the input, if this
/// is larger, up to 1024 spacings. Hence a vertex that rounding moved farther than 1024 spacings is
/// detected, and a large coordinate elsewhere does not increase the limit.
///
/// If a surface moves by at most e, the winding numbers of points farther than e do not change,
/// because the surface does not pass over them. Therefore a sample certifies all such points of its
/// cell, the connected part of space between faces. The distance e is Certificate::margin.
///
/// If the input has a border, its winding numbers are not integers. Then only new faces are tested.
/// Each new face must be a piece of an input face with the same orientation, up to movements of its
/// corners within the limit described above.
///
/// The intersections of the input are searched for, to find its uncut patches. The caller has to
/// check whether the output has intersections and whether it is a manifold. Deterministic for any
/// number of threads. Cost: O(n log n), and O(log n) per sample on usual meshes.
#pragma once

#include "transformesh/check_mesh.h"

namespace transformesh {

struct CertifyOptions {
  int winding_level = 1;
  Scalar coordinate = Scalar::float64;  ///< type in which the positions of the output were stored
  /// Largest number of faces of each kind; each face is sampled on both sides.
  std::size_t most_faces = 50000;
};

/// A certificate fails if the fraction of undecided samples is larger than this. A choice.
inline constexpr double most_undecided = 0.05;

Certificate certify(const Mesh& input, const Mesh& output, const CertifyOptions& options = {},
                    const Progress& progress = Progress());

}  // namespace transformesh
