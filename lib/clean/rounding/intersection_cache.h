/// Results of the last search for intersections (paper 4.3): pairs of faces whose corners have not
/// moved since need not be tested again. The answer is that of a test. Cost: O(n) a search, and
/// O(log k) a pair for k intersections.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "clean/intersect/intersect.h"
#include "mesh/triangle.h"

namespace transformesh {

class IntersectionCache {
 public:
  /// The faces that are searched now.
  void begin(const Mesh& mesh);
  /// Whether two of them intersect, where that is known.
  std::optional<bool> cross(Index f, Index g) const;
  /// Ends a search of all pairs of which one face is new; pairs are sorted, the lesser face first.
  void end(const Mesh& mesh, std::vector<char> is_new, std::vector<FacePair> intersections);

 private:
  std::vector<Triangle> triangles_;  ///< of the last search
  std::vector<char> is_new_;
  std::vector<FacePair> intersections_;
  std::vector<Index> before_;  ///< of each face now: which it was then, or no_index
};

}  // namespace transformesh
