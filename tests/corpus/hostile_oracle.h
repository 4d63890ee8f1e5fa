/// Judges a result of clean() by winding numbers at sample points, in exact arithmetic, with local
/// tolerances. A vertex may move by a number of spacings of its own coordinates; for a point of a
/// face, this tolerance is interpolated between the corners. A sample counts only if no face of the
/// input can reach it within the tolerance. So a distant vertex raises the tolerance only along its
/// own faces, and in proportion. A part without a distant vertex is judged to the spacing of its
/// own coordinates. Shares no code with the folders that it judges.
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
