/// Signed distances of the vertices of a mesh from a plane, and intersections of edges with the
/// plane. The side of each vertex is decided exactly for the numbers of the plane as given, so that
/// a plane can touch a vertex or contain a face.
#pragma once

#include <vector>

#include "transformesh/select.h"

namespace transformesh {

class PlaneDistances {
 public:
  /// Keeps a reference to the mesh. Throws UsageError if the normal has no direction.
  PlaneDistances(const Mesh& mesh, const CutPlane& plane);

  /// Returns the distance of a vertex from the plane, positive on the side of the normal.
  /// Its sign is exact: the distance is 0 if and only if the vertex is in the plane.
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
  /// The ends must not be strictly on the same side, and not both in the plane.
  Crossing crossing(Index a, Index b) const;
  const Vec3& normal() const { return normal_; }  ///< normal of the plane, of unit length

 private:
  const Mesh& mesh_;
  Vec3 normal_;
  double offset_;
  std::vector<double> distances_;
};

}  // namespace transformesh
