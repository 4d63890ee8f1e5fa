/// Signed distances of the vertices of a mesh from a plane, and intersections of edges with the
/// plane.
#pragma once

#include <vector>

#include "transformesh/select.h"

namespace transformesh {

class PlaneDistances {
 public:
  /// Keeps a reference to the mesh. Throws UsageError if the normal has no direction.
  PlaneDistances(const Mesh& mesh, const CutPlane& plane);

  /// Returns the distance of a vertex from the plane, positive on the side of the normal.
  double operator[](Index vertex) const { return distances_[vertex]; }
  /// True if the ends of an edge are strictly on different sides.
  bool is_crossed(Index a, Index b) const {
    return (distances_[a] < 0 && distances_[b] > 0) || (distances_[a] > 0 && distances_[b] < 0);
  }

  struct Crossing {
    Index low = 0, high = 0;  ///< ends of the edge
    double weight = 0;        ///< weight of the end `high`, in [0, 1]
    Vec3 position = Vec3::Zero();
  };
  /// Returns the intersection of an edge with the plane; independent of the direction of the edge.
  Crossing crossing(Index a, Index b) const;
  const Vec3& normal() const { return normal_; }  ///< normal of the plane, of unit length

 private:
  const Mesh& mesh_;
  Vec3 normal_;
  double offset_;
  std::vector<double> distances_;
};

}  // namespace transformesh
