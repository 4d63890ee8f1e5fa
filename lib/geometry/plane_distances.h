/// On which side of a plane the vertices of a mesh lie, and where edges cross the plane.
#pragma once

#include <vector>

#include "transformesh/select.h"

namespace transformesh {

class PlaneDistances {
 public:
  /// Keeps a reference to the mesh. Throws UsageError for a normal without direction.
  PlaneDistances(const Mesh& mesh, const CutPlane& plane);

  /// Distance of a vertex from the plane, positive where the normal points to.
  double operator[](Index vertex) const { return distances_[vertex]; }
  /// True if the ends of an edge lie strictly on different sides.
  bool is_crossed(Index a, Index b) const {
    return (distances_[a] < 0 && distances_[b] > 0) || (distances_[a] > 0 && distances_[b] < 0);
  }

  struct Crossing {
    Index low = 0, high = 0;  ///< ends of the edge
    double weight = 0;        ///< weight of the end `high`, in [0, 1]
    Vec3 position = Vec3::Zero();
  };
  /// The crossing of an edge, the same in both directions.
  Crossing crossing(Index a, Index b) const;
  const Vec3& normal() const { return normal_; }  ///< unit length

 private:
  const Mesh& mesh_;
  Vec3 normal_;
  double offset_;
  std::vector<double> distances_;
};

}  // namespace transformesh
