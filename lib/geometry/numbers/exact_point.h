/// Points known by what defines them: a given point, an edge and a face, two coplanar edges, three
/// faces, or the mean of three other points. Each carries a ball in doubles that contains it;
/// predicates decide from the balls and recompute from the definition, in exact arithmetic, only
/// when the sign is not certain. So every answer is exact at nearly floating-point cost. Nothing is
/// perturbed.
/// References: Attene, "Indirect predicates for geometric constructions", CAD 2020; Cherchi et al.,
/// "Fast and robust mesh arrangements using floating-point arithmetic", ACM TOG 2020.
/// Thread-safe as long as each thread uses its own copies of points (exact coordinates are cached
/// in the point); deterministic.
#pragma once

#include <memory>
#include <span>

#include "geometry/numbers/bounded_number.h"
#include "geometry/numbers/point_definition.h"
#include "geometry/numbers/predicates.h"

namespace transformesh {

struct ExactCoordinates;
struct PreciseCoordinates;
template <class Number>
struct HomogeneousPoint;
struct PreciseNormal;
struct ExactPlaneCoordinates;

struct ExactPoint {
  using Kind = PointDefinition::Kind;

  PointDefinition definition;
  Vec3 center = Vec3::Zero();  ///< the point is within radius of center, per coordinate
  Vec3 radius = Vec3::Zero();
  mutable std::shared_ptr<const PreciseCoordinates> precise;  ///< filled when first needed
  mutable std::shared_ptr<const ExactCoordinates> exact;      ///< likewise
};

/// Whether both have the same definition, and so are equal without any arithmetic.
inline bool same_definition(const ExactPoint& a, const ExactPoint& b) {
  return a.definition == b.definition && a.definition.is_known();
}

/// The plane of a triangle, which is not degenerate.
struct ExactPlane {
  Triangle triangle;
  mutable std::shared_ptr<const PreciseNormal> precise = nullptr;  ///< filled when first needed
  mutable std::shared_ptr<const ExactPlaneCoordinates> exact = nullptr;  ///< likewise
};

class ExactGeometry {
 public:
  /// Keeps references: the vertices and faces that definitions name. Faces are not degenerate.
  ExactGeometry(std::span<const Vec3> positions, std::span<const Face> faces)
      : positions_(positions), faces_(faces) {}

  /// The point of a definition, but of those by three planes.
  ExactPoint point(const PointDefinition& definition) const;
  /// Where the planes of three faces meet, inside g and h.
  ExactPoint three_planes(Index f, Index g, Index h) const;
  ExactPoint given(Index vertex) const { return point(PointDefinition::given(vertex)); }
  /// A point with coordinates of its own: for scaffolding.
  static ExactPoint free(const Vec3& position);

  /// The kind and the vertices of a definition; those of faces and edges are sorted, and so are the
  /// faces. It does not depend on the order of the faces of the mesh.
  std::array<Index, 10> vertices_of(const PointDefinition& definition) const;

  /// As in predicates.h.
  int orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
               PlaneProjection projection) const;
  /// Twice the area of abc in the projection, from the balls.
  static BoundedNumber bounded_orient2d(const ExactPoint& a, const ExactPoint& b,
                                        const ExactPoint& c, PlaneProjection projection);
  /// orient2d if the balls decide it, else 0.
  static int quick_orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                            PlaneProjection projection);
  /// Of triangles abc and bad in one plane that turn counter-clockwise: +1 where their diagonal ab
  /// is Delaunay, -1 where cd is, and 0 where the four are on a circle.
  int delaunay_sign(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                    const ExactPoint& d, PlaneProjection projection) const;
  /// The same if the balls decide it, else 0.
  static int quick_delaunay_sign(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                 const ExactPoint& d, PlaneProjection projection);
  int orient3d(const Triangle& triangle, const ExactPoint& point) const;
  int orient3d(const ExactPlane& plane, const ExactPoint& point) const;
  ExactPlane plane(Index face) const { return {triangle(face)}; }
  /// An order by x, then y, then z: -1, 0 or +1. Zero exactly where the points are equal.
  int compare(const ExactPoint& a, const ExactPoint& b) const;
  int compare_coordinate(const ExactPoint& a, const ExactPoint& b, int i) const;
  /// In doubles, within one unit in the last place.
  Vec3 position(const ExactPoint& point) const;
  /// The weighted mean of three points; weights are positive integers.
  ExactPoint mean(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                  const std::array<int, 3>& weights) const;

 private:
  ExactPoint line_plane(const PointDefinition& definition) const;
  ExactPoint line_line(const PointDefinition& definition) const;
  const PreciseCoordinates& precise(const ExactPoint& point) const;
  template <class Ball>
  const HomogeneousPoint<Ball>& spread(const ExactPoint& point) const;
  /// The sign of what `compute` makes of the points' homogeneous coordinates, by balls where these
  /// are long, and else exactly.
  template <class Compute, class... Point>
  int homogeneous_sign(const Compute& compute, const Point&... points) const;
  const ExactCoordinates& exact(const ExactPoint& point) const;
  Triangle triangle(Index face) const;

  std::span<const Vec3> positions_;
  std::span<const Face> faces_;
};

}  // namespace transformesh
