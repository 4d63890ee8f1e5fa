/// Exact winding numbers just in front of a face or of a piece of it (paper 2), by counting the
/// closed faces that a ray from there crosses. Gives the seeds of region growing (paper 3.2.1) and
/// all values of the static strategy (paper 4.5). (RayCastWinding gives the number at a point off
/// the surface.)
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "clean/arrange/arrange.h"
#include "clean/exterior/surroundings.h"
#include "geometry/search/bvh.h"

namespace transformesh {

class RayCastFrontWinding {
 public:
  /// Rays meet the closed faces, and those around the mesh if there are any. `rays` is about how
  /// many will be cast: if they are few, each is tested with all faces, which costs less than
  /// building a hierarchy. Keeps references.
  RayCastFrontWinding(const WeldedMesh& welded, std::size_t rays,
                      const Surroundings* around = nullptr);

  /// The winding number just in front of a piece. A ray that grazes an edge or a corner is replaced
  /// by one from another point of the piece, until one crosses faces in their interiors only.
  /// Throws GoalError where there is none among 20000.
  int in_front_of(const Arrangement& arrangement, const Piece& piece) const;
  /// Just in front of a part of a face, which is a triangle within it.
  int in_front_of(const std::array<ExactPoint, 3>& part, Index face) const;
  /// Just in front of a face at a point inside it, which is on no other face. Nothing where the ray
  /// from there grazes an edge or a corner.
  std::optional<int> in_front_of(const ExactPoint& point, Index face) const;

 private:
  struct Count {
    bool grazes = false;
    int winding = 0;
  };
  int in_front_of(const std::array<ExactPoint, 3>& part, const PieceSource& source) const;
  std::pair<int, int> axis_and_direction(const PieceSource& source) const;
  Count cast(const ExactPoint& origin, int axis, int direction) const;
  void visit_overlaps(const Vec3& low, const Vec3& high,
                      const std::function<bool(Index)>& visit) const;

  const WeldedMesh& welded_;
  const Surroundings* around_;  ///< null if there are none
  Bvh bvh_;                     ///< all faces; empty if rays are few
};

}  // namespace transformesh
