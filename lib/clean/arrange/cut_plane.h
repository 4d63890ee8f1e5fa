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

/// A welded face that covers a piece.
struct PieceSource {
  Index face;
  bool reversed;  ///< true if the face and the piece have opposite orientations
};

/// Classification of a facet in a plane that contains open faces.
struct OpenFacet {
  bool is_open;  ///< true if the facet is a piece of open faces; false if it bounds the closed part
  /// Winding number of the closed part in front of the piece; for an open piece, the larger of the
  /// winding numbers on both sides.
  int front;
};

/// The pieces of one plane. Their order does not depend on which other planes are cut. Points are
/// numbered per plane.
struct PlaneCut {
  std::vector<ExactPoint> points;
  std::vector<Face> facets;  ///< indices into `points`; oriented like the first face of the plane
  /// Facet `i` has the sources [source_offsets[i], source_offsets[i + 1]).
  std::vector<Index> source_offsets;
  /// Sources of all facets, sorted by face within each facet. Only the first copy of a face is
  /// listed.
  std::vector<PieceSource> sources;
  std::vector<Index> numbers;  ///< for each facet its index in `PlaneFacets`
  /// Classification of each facet; empty if all faces are closed.
  std::vector<OpenFacet> open{};
};

/// All facets of the triangulation of a plane, among which a caller chooses pieces. The facets are
/// oriented like the first face of the plane. They also cover the scaffold around the faces.
class PlaneFacets {
 public:
  virtual ~PlaneFacets() = default;
  virtual std::size_t size() const = 0;
  virtual bool is_covered(Index facet) const = 0;  ///< true if at least one face covers the facet
  /// Number of closed faces that cover the facet, including copies, minus the number of reversed
  /// ones. The winding number grows by this amount from front to back.
  virtual int multiplicity(Index facet) const = 0;
  virtual bool has_open_face(Index facet) const = 0;  ///< true if an open face covers the facet
  /// Returns the facet across edge `i`, or no_index outside the scaffold.
  virtual Index neighbor(Index facet, Index i) const = 0;
  /// Returns the change of the winding number in front of the plane across edge `i`, from `facet`
  /// to its neighbor. Both facets must be covered.
  virtual int jump(Index facet, Index i) const = 0;
  virtual std::array<ExactPoint, 3> corners(Index facet) const = 0;
  /// Returns the facet of the first face of the plane at corner `i` of that face.
  virtual Index facet_at_corner(Index i) const = 0;
};

/// Returns a nonzero entry for each facet that becomes a piece. Uncovered facets must stay 0.
using ChooseFacets = std::function<std::vector<char>(const PlaneFacets&)>;

/// Makes a piece of each covered facet.
PlaneCut cut_plane(const WeldedMesh& welded, const Plane& plane);
/// Makes a piece of each facet that `choose` marks.
PlaneCut cut_plane(const WeldedMesh& welded, const Plane& plane, const WindingJumps& jumps,
                   const ChooseFacets& choose);

}  // namespace transformesh
