/// Exact winding numbers just in front of a face or of a piece of a cut face (paper 2). A ray that
/// starts there counts the closed faces that it crosses. Used for the first faces of region growing
/// (paper 3.2.1), and for all pieces by the static strategy (paper 4.5). The class RayCastWinding
/// gives the winding number at a point off the surface instead. Cost: O(n log n) to build the
/// hierarchy; O(log n + crossed boxes) per ray.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "clean/arrange/arrange.h"
#include "clean/exterior/local_references.h"
#include "geometry/search/bvh.h"

namespace transformesh {

/// A face that a ray crosses, and its contribution (1 or -1) to the winding number w at the start
/// of the ray.
struct FaceCrossing {
  Index face;
  int winding;
};

class RayCastFrontWinding {
 public:
  /// `rays` is the approximate number of rays. Up to 8 rays are tested against all faces, which
  /// costs less than building a hierarchy. If `welded` is only a part of a mesh, pass `around`:
  /// rays are then replaced by segments from nearby points with known winding numbers
  /// (local_references.h). Keeps references to the arguments.
  RayCastFrontWinding(const WeldedMesh& welded, std::size_t rays,
                      const Surroundings* around = nullptr);

  /// Returns the winding number just in front of a piece. If a ray or segment touches an edge or a
  /// corner, it is replaced by one from a different point of the piece. Throws GoalError after
  /// 20000 attempts.
  int in_front_of(const Arrangement& arrangement, const Piece& piece) const;
  /// Returns the faces that a ray from the front of the piece crosses, with their contributions.
  /// The sum of the contributions is the winding number just in front of the piece.
  std::vector<FaceCrossing> crossings_in_front_of(const Arrangement& arrangement,
                                                  const Piece& piece) const;
  std::vector<FaceCrossing> crossings_in_front_of(Index face) const;
  /// Returns the winding number just in front of `part`, a triangle inside `face`.
  int in_front_of(const std::array<ExactPoint, 3>& part, Index face) const;
  /// Returns the winding number just in front of a face at a point inside it. The point must be on
  /// no other face. Returns nothing if the ray touches an edge or a corner.
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
  Bvh bvh_;  ///< hierarchy of all faces; empty if there are few rays
  /// Null unless the mesh is a part of a larger mesh.
  std::unique_ptr<LocalReferences> references_;
};

}  // namespace transformesh
