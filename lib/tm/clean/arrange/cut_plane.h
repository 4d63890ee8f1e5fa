/// Cuts coplanar faces that meet (usually a single face) along their edges and along everything
/// that crosses them.
#pragma once

#include <vector>

#include "tm/clean/intersect/contacts.h"
#include "tm/geometry/exact_point.h"

namespace transformesh {

/// A face of the soup that covers a piece, and whether it looks the other way.
struct PieceSource {
  Index face;
  bool reversed;
};

/// Two faces in different planes that meet, and where.
struct Meeting {
  Index first;
  Index second;
  Contacts contacts;
};

/// The pieces of one plane, with points of their own numbering.
struct PlaneCut {
  std::vector<ExactPoint> points;
  std::vector<Face> facets;           ///< into points; they look the way the first face does
  std::vector<Index> source_offsets;  ///< facet i has sources [offsets[i], offsets[i + 1])
  std::vector<PieceSource> sources;   ///< ascending faces
};

/// `faces` ascend; `meetings` are those in which one of them takes part.
PlaneCut cut_plane(const Soup& soup, const std::vector<Index>& faces,
                   const std::vector<const Meeting*>& meetings);

}  // namespace transformesh
