/// Judges a result of clean() by winding numbers at sample points, in exact arithmetic, with
/// tolerances that are local. A vertex may move by a number of spacings of its own coordinates, and
/// so a point of a face by what the face's corners may, by the same weights: a sample counts where
/// no face of the input reaches it by that. So a far vertex excuses nothing but along its own
/// faces, and there in proportion; what has no far vertex is judged to the spacing of its own
/// coordinates. Shares no code with the floors that it judges.
#pragma once

#include <cstdint>
#include <string>

#include "transformesh/mesh.h"

namespace transformesh::corpus {

struct LocalSamples {
  std::size_t tested = 0;
  std::size_t wrong = 0;
  std::size_t undecided = 0;
  std::string first_wrong;
};

LocalSamples sample_locally(const Mesh& input, const Mesh& output, Scalar type, int samples,
                            double spacings, std::uint64_t seed);

}  // namespace transformesh::corpus
