/// Whether one mesh is the boundary of { p : w(p) >= winding level } of another, told by sample
/// points. At every sample the winding number of the output must be 1 where that of the input is >=
/// winding level, and 0 elsewhere. It is counted along rays, exactly, and compared with the sum of
/// solid angles where that is affordable: by no code that computes such boundaries.
///
/// Samples lie in front of and behind a face, closer to it than any other face of either mesh. The
/// faces sampled are all new faces of the output (those that are not faces of the input, corner by
/// corner), four faces of every uncut patch of the input (certify_faces.h), the faces of the input
/// that were cut, and 4000 others of both meshes; of each kind at most `most_faces`, evenly spread.
/// A sample is undecided where no point beside the face is farther from all new faces, and from the
/// faces that are gone, than rounding may have moved them: along each axis twice the spacing of
/// `coordinate` at the face; for a new face 4 times as far as it is seen to be from the input, if
/// that is more, up to 1024 times that spacing. So a vertex moved by more than that is noticed, and
/// a far vertex excuses nothing elsewhere.
///
/// A surface that moves by at most e keeps its winding numbers at all points farther than e from
/// it, since it sweeps over none of them: the samples speak for every such point of their cells, e
/// being the certificate's margin.
///
/// Winding numbers of an input with a border are no integers. Then all that is tested is that each
/// new face is a piece of one of the input to the same distance, and not turned but by such moves.
///
/// The input's intersections are searched for. Whether the output has any, and whether it is a
/// manifold, is for the caller to check. Deterministic for any number of threads. Cost: O(n log n),
/// and O(log n) a sample on usual meshes.
#pragma once

#include "transformesh/check_mesh.h"

namespace transformesh {

struct CertifyOptions {
  int winding_level = 1;
  Scalar coordinate = Scalar::float64;  ///< the type in which the output's positions were stored
  std::size_t most_faces = 50000;       ///< of each kind; every face is sampled on both sides
};

/// More than this share of undecided samples is a problem.
inline constexpr double most_undecided = 0.05;

Certificate certify(const Mesh& input, const Mesh& output, const CertifyOptions& options = {},
                    const Progress& progress = Progress());

}  // namespace transformesh
