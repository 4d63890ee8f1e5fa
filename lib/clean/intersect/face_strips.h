/// Strips of long thin faces: the space between two parallel planes that stand on the face, one of
/// them on its longest edge. Two faces are apart if all corners of one are on one side of the strip
/// of the other. The boxes of long thin faces that lie side by side across the axes overlap, but
/// their strips do not. The test of two strips takes a tenth of the time of find_contacts()
/// (contacts.h), which has to be exact where faces lie in nearly one plane. Reference: Gottschalk,
/// Lin & Manocha, "OBBTree: a hierarchical structure for rapid interference detection", SIGGRAPH
/// 1996, for separating axes.
#pragma once

#include <span>
#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

class FaceStrips {
 public:
  /// Makes the strips of those faces that are long and thin. O(n); parallel; deterministic.
  FaceStrips(const WeldedMesh& welded, std::span<const Index> faces);

  /// Whether the strip of one face, by its place in the list, shows that they are apart.
  bool are_apart(std::size_t first, std::size_t second) const {
    return is_beside(first, second) || is_beside(second, first);
  }

 private:
  /// The computed values of direction * p are in [low, high] for all points p of the face. Both
  /// bounds include the rounding errors of such values for any point of the mesh.
  struct Strip {
    Vec3 direction;
    double low, high;
  };
  bool is_beside(std::size_t face, std::size_t other) const;
  static Strip strip_of(const Triangle& t, const Vec3& largest);

  const WeldedMesh& welded_;
  std::span<const Index> faces_;
  std::vector<Index> place_of_;  ///< in strips_, per face of the list; no_index if it is not thin
  std::vector<Strip> strips_;
};

inline bool FaceStrips::is_beside(std::size_t face, std::size_t other) const {
  if (place_of_[other] == no_index) return false;
  const Strip& strip = strips_[place_of_[other]];
  const Triangle t = welded_.triangle(faces_[face]);
  const double a = strip.direction.dot(t[0]), b = strip.direction.dot(t[1]),
               c = strip.direction.dot(t[2]);
  return (a > strip.high && b > strip.high && c > strip.high) ||
         (a < strip.low && b < strip.low && c < strip.low);
}

}  // namespace transformesh
