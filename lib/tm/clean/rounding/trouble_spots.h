/// Where repair after rounding failed, and how often: such places are treated otherwise at the next
/// start, while the rest of the mesh keeps what settles it (settle.h).
#pragma once

#include <vector>

#include "tm/clean/stitch/assemble.h"
#include "tm/geometry/bvh.h"

namespace transformesh {

class TroubleSpots {
 public:
  explicit TroubleSpots(const Mesh& mesh);

  /// Repair failed at these faces once more.
  void add(const Assembly& assembly, const std::vector<Index>& faces);
  /// How often it failed where the face is.
  int failures_at(const Mesh& mesh, Index face) const;
  /// At most how often it failed at faces that come from that face of the input.
  const std::vector<int>& failures_of_input() const { return failures_of_input_; }
  int most_failures() const { return most_failures_; }

 private:
  FloatBox box(const Mesh& mesh, Index face) const;

  BoxFrame frame_;
  std::vector<FloatBox> boxes_;
  std::vector<int> failures_;  ///< per box
  Bvh bvh_;
  std::vector<int> failures_of_input_;
  int most_failures_ = 0;
};

}  // namespace transformesh
