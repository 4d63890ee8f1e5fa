/// Triangles of which an earlier search has found that no two intersect. A later search of a mesh
/// that still has many of these triangles need not test them with each other (find_meetings.h).
/// Triangles are compared by the positions of their corners. Therefore a set stays valid while the
/// mesh changes, and its vertices and faces are renumbered.
#pragma once

#include <span>
#include <vector>

#include "mesh/triangle.h"
#include "support/first_of_equal.h"
#include "transformesh/mesh.h"

namespace transformesh {

class DisjointFaces {
 public:
  DisjointFaces() = default;
  /// Stores the given faces of a mesh. No two of them may intersect, except that faces with equal
  /// corners count as one. O(n).
  DisjointFaces(const Mesh& mesh, std::span<const Index> faces);

  bool empty() const { return triangles_.empty(); }
  /// Returns 1 for each face of a mesh that has the corners of a stored triangle, in any order.
  /// O(n); parallel.
  std::vector<char> find(const std::vector<Vec3>& points, const std::vector<Face>& faces) const;

 private:
  std::vector<Triangle> triangles_;
  FirstOfEqual numbers_;
};

}  // namespace transformesh
