/// Cuts coplanar faces that meet (usually a single face) along their edges and along all faces that
/// cross them: the constrained triangulation of paper 3.2.3.
#pragma once

#include <vector>

#include "tm/clean/intersect/contacts.h"
#include "tm/geometry/exact_point.h"

namespace transformesh {

/// A welded face that covers a piece.
struct PieceSource {
  Index face;
  bool reversed;  ///< its orientation is opposite to that of the piece
};

/// Two faces that meet, and where.
struct Meeting {
  Index first;
  Index second;
  Contacts contacts;
};

/// The pieces of one plane. Its points have numbers of their own, of which the first three are the
/// scaffold of the triangulation.
struct PlaneCut {
  std::vector<ExactPoint> points;
  std::vector<Face> facets;           ///< by points; oriented as the first face is
  std::vector<Index> source_offsets;  ///< facet i has sources [offsets[i], offsets[i + 1])
  std::vector<PieceSource> sources;   ///< of each facet by ascending faces
};

/// `faces` ascend; `meetings` are theirs with faces in other planes.
PlaneCut cut_plane(const WeldedMesh& welded, const std::vector<Index>& faces,
                   const std::vector<const Meeting*>& meetings);

}  // namespace transformesh
