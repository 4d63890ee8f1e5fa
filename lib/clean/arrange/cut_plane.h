/// Cuts a set of coplanar faces that meet (usually a single face) along the edges of these faces
/// and along all faces that intersect them. The result is the constrained triangulation of paper
/// 3.2.3. Cost: that of the triangulation in `planar_triangulation.h`.
#pragma once

#include <functional>
#include <vector>

#include "clean/arrange/planes.h"
#include "clean/arrange/winding_jumps.h"
#include "geometry/numbers/exact_point.h"

namespace transformesh {

/// A welded face that contains a piece of an arrangement.
struct PieceSource {
  Index face;
  bool reversed;  ///< true if the face and the piece have opposite orientations
};

/// Classification of a facet (triangle) in a plane that contains faces of open components.
struct OpenFacet {
  /// True for a piece of open components, false for a piece of the closed part's boundary.
  bool is_open;
  /// Winding number of the closed part in front of the piece; for an open piece, the larger of the
  /// winding numbers on both sides.
  int front;
};

/// The pieces of one plane (a face, or coplanar faces that meet). Their order does not depend on
/// which other planes are cut. Points are numbered separately in each plane.
struct PlaneCut {
  std::vector<ExactPoint> points;
  std::vector<Face> facets;  ///< indices into `points`; oriented like the first face of the plane
  /// The sources of facet `i` start at index `source_offsets[i]`, and end before index
  /// `source_offsets[i + 1]`.
  std::vector<Index> source_offsets;
  /// Sources (the faces that contain a facet) of all facets, sorted by face for each facet. Of
  /// several faces with the same three points, only the first is listed.
  std::vector<PieceSource> sources;
  /// For each facet its index in the `PlaneFacets` from which it was chosen.
  std::vector<Index> numbers;
  /// Classification of each facet; empty if all faces are closed.
  std::vector<OpenFacet> open{};
};

/// All facets (triangles) of the triangulation of a plane, from which the caller chooses those that
/// become pieces. The facets are oriented like the first face of the plane. They fill a large
/// triangle around the faces (scaffold), so some facets are in no face.
class PlaneFacets {
 public:
  virtual ~PlaneFacets() = default;
  virtual std::size_t size() const = 0;
  /// True if the facet is inside at least one face.
  virtual bool is_covered(Index facet) const = 0;
  /// Number of faces of the closed part that contain the facet and have its orientation, minus the
  /// number of those with the opposite orientation. Coincident faces count separately. The winding
  /// number grows by this amount from front to back.
  virtual int multiplicity(Index facet) const = 0;
  /// True if the facet is inside a face of an open component.
  virtual bool has_open_face(Index facet) const = 0;
  /// Returns the facet across edge `i`, or no_index if the edge is on the boundary of the
  /// triangulation.
  virtual Index neighbor(Index facet, Index i) const = 0;
  /// Returns the change of the winding number in front of the plane across edge `i`, from `facet`
  /// to its neighbor. is_covered() must be true for both facets.
  virtual int jump(Index facet, Index i) const = 0;
  virtual std::array<ExactPoint, 3> corners(Index facet) const = 0;
  /// Returns the facet that is inside the first face of the plane, at corner `i` of this face.
  virtual Index facet_at_corner(Index i) const = 0;
};

/// Function that returns a nonzero entry for each facet that becomes a piece. The entries of facets
/// outside all faces must be 0.
using ChooseFacets = std::function<std::vector<char>(const PlaneFacets&)>;

/// Cuts the faces of a plane along all intersections. Each facet inside a face becomes a piece.
PlaneCut cut_plane(const WeldedMesh& welded, const Plane& plane);
/// Cuts the faces of a plane along all intersections. The facets for which `choose` returns a
/// nonzero entry become pieces.
PlaneCut cut_plane(const WeldedMesh& welded, const Plane& plane, const WindingJumps& jumps,
                   const ChooseFacets& choose);

}  // namespace transformesh
