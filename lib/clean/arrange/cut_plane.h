/// Cuts coplanar faces that meet (usually a single face) along their edges and along all faces that
/// intersect them: the constrained triangulation of paper 3.2.3.
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
  bool reversed;  ///< its orientation is opposite to that of the piece
};

/// A facet of a plane with open faces.
struct OpenFacet {
  bool is_open;  ///< whether it is kept for its open faces; else it bounds the closed part
  int front;     ///< the winding number of the closed part in front of it
};

/// The pieces of one plane, in an order that does not depend on which others there are. Its points
/// have numbers of their own.
struct PlaneCut {
  std::vector<ExactPoint> points;     ///< of the pieces
  std::vector<Face> facets;           ///< by points; oriented as the first face is
  std::vector<Index> source_offsets;  ///< facet i has sources [offsets[i], offsets[i + 1])
  std::vector<PieceSource> sources;   ///< of each facet by ascending faces; copies are not named
  std::vector<Index> numbers;         ///< facets among those to choose from
  /// Per facet; empty if all faces are closed.
  std::vector<OpenFacet> open{};
};

/// The facets of a plane that was cut, to choose from. They are oriented as the first face of the
/// plane is, and go beyond the faces.
class PlaneFacets {
 public:
  virtual ~PlaneFacets() = default;
  virtual std::size_t size() const = 0;
  virtual bool is_covered(Index facet) const = 0;  ///< by some face
  /// The closed faces that cover it, copies counted, less reversed ones: by how much w grows
  /// behind.
  virtual int multiplicity(Index facet) const = 0;
  virtual bool has_open_face(Index facet) const = 0;  ///< an open face covers it
  /// The facet across edge i.
  virtual Index neighbor(Index facet, Index i) const = 0;
  /// By how much w in front grows across edge i, where both facets are covered.
  virtual int jump(Index facet, Index i) const = 0;
  virtual std::array<ExactPoint, 3> corners(Index facet) const = 0;
  /// A facet of the first face at its corner i.
  virtual Index facet_at_corner(Index i) const = 0;
};

/// Marks the facets that become pieces. Those that are not covered never do.
using ChooseFacets = std::function<std::vector<char>(const PlaneFacets&)>;

/// All covered facets become pieces.
PlaneCut cut_plane(const WeldedMesh& welded, const Plane& plane);
/// Chosen ones do.
PlaneCut cut_plane(const WeldedMesh& welded, const Plane& plane, const WindingJumps& jumps,
                   const ChooseFacets& choose);

}  // namespace transformesh
