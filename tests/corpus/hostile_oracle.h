/// Judges a result of clean() by winding numbers at sample points, in exact arithmetic, with
/// tolerances that are local: a sample counts where it is farther from every face of the input than
/// a number of spacings of its own coordinates. So a far vertex excuses nothing near the origin.
/// Shares no code with the floors that it judges.
#pragma once

#include <cstdint>
#include <string>

#include "tm/mesh/mesh.h"

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
