/// Where repair after rounding failed, and how often (paper 4.3). At the next start such places are
/// repaired in other ways, while the rest of the mesh keeps those that worked (snap_rounding.h).
#pragma once

#include <vector>

#include "tm/clean/stitch/assemble.h"
#include "tm/geometry/bvh.h"

namespace transformesh {

class TroubleSpots {
 public:
  explicit TroubleSpots(const Mesh& mesh);

  /// Notes that repair failed at these faces once more.
  void add(const Assembly& assembly, const std::vector<Index>& faces);
  /// How often repair failed in places that the box of the face touches; the most counts.
  int failures_at(const Mesh& mesh, Index face) const;
  /// Per face of the input: how often repair failed at a face that is cut from it; the most counts.
  const std::vector<int>& failures_of_input() const { return failures_of_input_; }
  int most_failures() const { return most_failures_; }

 private:
  FloatBox box(const Mesh& mesh, Index face) const;

  BoxFrame frame_;
  std::vector<FloatBox> boxes_;
  std::vector<int> failures_;  ///< of each box
  Bvh bvh_;
  std::vector<int> failures_of_input_;
  int most_failures_ = 0;
};

}  // namespace transformesh
