/// Exact winding numbers just in front of a face or of a piece of it (paper 2), by counting the
/// closed faces that a ray from there crosses. Gives the seeds of region growing (paper 3.2.1) and
/// all values of the static strategy (paper 4.5). (RayCastWinding gives the number at a point off
/// the surface.)
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "clean/arrange/arrange.h"
#include "clean/exterior/local_references.h"
#include "geometry/search/bvh.h"

namespace transformesh {

/// A face that a ray crosses, and what it adds to w at the origin.
struct FaceCrossing {
  Index face;
  int winding;
};

class RayCastFrontWinding {
 public:
  /// `rays` is about how many will be cast: if they are few, each is tested with all faces, which
  /// costs less than building a hierarchy. In a part of a mesh, `around` replaces rays by segments
  /// from points nearby (local_references.h). Keeps references.
  RayCastFrontWinding(const WeldedMesh& welded, std::size_t rays,
                      const Surroundings* around = nullptr);

  /// The winding number just in front of a piece. A ray or segment that grazes an edge or a corner
  /// is replaced by one at another point of the piece, until one crosses faces in their interiors
  /// only.
  /// Throws GoalError where there is none among 20000.
  int in_front_of(const Arrangement& arrangement, const Piece& piece) const;
  /// The faces that the ray from there crosses, and by how much w changes at each: in sum, w just
  /// in front of the piece.
  std::vector<FaceCrossing> crossings_in_front_of(const Arrangement& arrangement,
                                                  const Piece& piece) const;
  std::vector<FaceCrossing> crossings_in_front_of(Index face) const;
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
  int in_front_of(const std::array<ExactPoint, 3>& part, const PieceSource& source,
                  std::vector<FaceCrossing>* crossings = nullptr) const;
  std::pair<int, int> axis_and_direction(const PieceSource& source) const;
  Count cast(const ExactPoint& origin, const PieceSource& source,
             std::vector<FaceCrossing>* crossings = nullptr) const;
  Count cast_ray(const ExactPoint& origin, const PieceSource& source,
                 std::vector<FaceCrossing>* crossings) const;
  Count cross_segment(const ReferencePoint& from, const ExactPoint& origin,
                      const PieceSource& source) const;
  void visit_overlaps(const Vec3& low, const Vec3& high,
                      const std::function<bool(Index)>& visit) const;

  const WeldedMesh& welded_;
  Bvh bvh_;                                      ///< all faces; empty if rays are few
  std::unique_ptr<LocalReferences> references_;  ///< null for a whole mesh
};

}  // namespace transformesh
