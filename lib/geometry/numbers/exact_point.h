/// Points given by their definition: a mesh vertex, an edge and a face, two coplanar edges, three
/// faces, or the mean of three other points. Each point has a ball in doubles that contains it.
/// Predicates use the balls first. Only if the sign is uncertain, they recompute from the
/// definition, in double-double and then in exact arithmetic. Hence every answer is exact at nearly
/// floating-point cost. Nothing is perturbed.
///
/// References: Attene, "Indirect predicates for geometric constructions", CAD 2020; Cherchi et al.,
/// "Fast and robust mesh arrangements using floating-point arithmetic", ACM TOG 2020. Departure:
/// balls of double-double and multiprecision numbers precede exact arithmetic.
///
/// Deterministic. Thread-safe if each thread uses its own copies of points, because points cache
/// exact coordinates.
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
  Vec3 center = Vec3::Zero();  ///< each coordinate of the point is within `radius` of `center`
  Vec3 radius = Vec3::Zero();
  /// Coordinates with an error bound, computed on demand.
  mutable std::shared_ptr<const PreciseCoordinates> precise;
  mutable std::shared_ptr<const ExactCoordinates> exact;  ///< exact coordinates, computed on demand
};

/// True if both points have the same definition, and hence are equal without arithmetic.
inline bool same_definition(const ExactPoint& a, const ExactPoint& b) {
  return a.definition == b.definition && a.definition.is_known();
}

/// The plane of a triangle that is not degenerate.
struct ExactPlane {
  Triangle triangle;
  /// Normal with an error bound, computed on demand.
  mutable std::shared_ptr<const PreciseNormal> precise = nullptr;
  /// Exact coordinates of the plane, computed on demand.
  mutable std::shared_ptr<const ExactPlaneCoordinates> exact = nullptr;
};

class ExactGeometry {
 public:
  /// Keeps references to the vertices and faces by which points are defined. Faces must not be
  /// degenerate.
  ExactGeometry(std::span<const Vec3> positions, std::span<const Face> faces)
      : positions_(positions), faces_(faces) {}

  /// Returns the point with this definition, whose kind must be `given`, `line_plane` or
  /// `line_line`.
  ExactPoint point(const PointDefinition& definition) const;
  /// Returns the intersection of the planes of three faces. The point must be inside the faces `g`
  /// and `h`.
  ExactPoint three_planes(Index f, Index g, Index h) const;
  ExactPoint given(Index vertex) const { return point(PointDefinition::given(vertex)); }
  /// Returns a point that is not defined by the mesh, with the given coordinates. An example is a
  /// corner of a triangle that encloses all points of a triangulation.
  static ExactPoint free(const Vec3& position);

  /// Returns the kind and the vertices of a definition, in an order that does not depend on the
  /// order of the faces of the mesh. The vertices of a face or edge are sorted, and so are the
  /// faces.
  std::array<Index, 10> vertices_of(const PointDefinition& definition) const;

  /// Returns the exact orientation of the projected triangle abc: +1 if it is counter-clockwise, -1
  /// if it is clockwise, 0 if it is collinear.
  int orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
               PlaneProjection projection) const;
  /// Returns twice the signed area of the projected triangle abc with an error bound. It is
  /// computed in doubles from the balls that contain the points.
  static BoundedNumber bounded_orient2d(const ExactPoint& a, const ExactPoint& b,
                                        const ExactPoint& c, PlaneProjection projection);
  /// Returns the orientation if the balls that contain the points decide it, otherwise 0.
  static int quick_orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                            PlaneProjection projection);
  /// Compares the diagonals of the coplanar triangles abc and bad, which must be counter-clockwise.
  /// Returns +1 if ab is Delaunay, -1 if cd is, and 0 if the four points are cocircular.
  int delaunay_sign(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                    const ExactPoint& d, PlaneProjection projection) const;
  /// Returns the result of delaunay_sign() if the balls that contain the points decide it,
  /// otherwise 0.
  static int quick_delaunay_sign(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                 const ExactPoint& d, PlaneProjection projection);
  int orient3d(const Triangle& triangle, const ExactPoint& point) const;
  int orient3d(const ExactPlane& plane, const ExactPoint& point) const;
  ExactPlane plane(Index face) const { return {triangle(face)}; }
  /// Compares by x, then y, then z: -1, 0 or +1. Returns 0 if and only if the points are equal.
  int compare(const ExactPoint& a, const ExactPoint& b) const;
  int compare_coordinate(const ExactPoint& a, const ExactPoint& b, int i) const;
  /// Returns the position of a point, rounded to doubles. The error is within one unit in the last
  /// place.
  Vec3 position(const ExactPoint& point) const;
  /// Returns the weighted mean of three points; the weights must be positive integers.
  ExactPoint mean(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                  const std::array<int, 3>& weights) const;

 private:
  ExactPoint line_plane(const PointDefinition& definition) const;
  ExactPoint line_line(const PointDefinition& definition) const;
  const PreciseCoordinates& precise(const ExactPoint& point) const;
  template <class Ball>
  const HomogeneousPoint<Ball>& spread(const ExactPoint& point) const;
  /// Returns the sign of `compute`, applied to the homogeneous coordinates of the points. Uses
  /// exact numbers. If magnitudes differ strongly, tries balls (numbers with an error bound) first.
  template <class Compute, class... Point>
  int homogeneous_sign(const Compute& compute, const Point&... points) const;
  const ExactCoordinates& exact(const ExactPoint& point) const;
  Triangle triangle(Index face) const;

  std::span<const Vec3> positions_;
  std::span<const Face> faces_;
};

}  // namespace transformesh
