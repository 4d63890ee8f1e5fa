/// The exact arrangement of a mesh with itself (paper 3.2.3): every face that takes part in an
/// intersection is cut along all others, so that pieces meet only in equal corners and equal edges.
/// Faces that take no part stay whole. Coplanar faces that meet are cut together, and where they
/// overlap they share one piece.
#pragma once

#include <memory>
#include <span>

#include "tm/clean/arrange/cut_plane.h"
#include "tm/clean/intersect/intersect.h"
#include "tm/clean/intersect/soup.h"
#include "tm/geometry/exact_point.h"
#include "tm/support/progress.h"

namespace transformesh {

struct Piece {
  Face corners;        ///< arrangement points
  Index first_source;  ///< its sources are [first_source, first_source + source_count)
  std::uint32_t source_count;
  std::int32_t winding;  ///< by how much w grows from front to back: sources less reversed ones;
                         ///< never negative, and 0 where the sources cancel out
};

struct Arrangement {
  std::shared_ptr<const Soup> soup;
  std::vector<ExactPoint>
      cut_points;             ///< arrangement point i is cut_points[i - soup.points.size()]
  std::vector<Piece> pieces;  ///< whole faces first, in order, then the cut ones
  std::vector<PieceSource> sources;
  std::size_t whole_pieces = 0;

  ExactGeometry geometry() const { return {soup->points, soup->faces}; }
  ExactPoint point(Index i) const {
    return i < soup->points.size() ? geometry().given(i) : cut_points[i - soup->points.size()];
  }
  /// In doubles, within one unit in the last place.
  Vec3 position(Index i) const {
    return i < soup->points.size() ? soup->points[i]
                                   : geometry().position(cut_points[i - soup->points.size()]);
  }
  std::size_t point_count() const { return soup->points.size() + cut_points.size(); }
  std::span<const PieceSource> sources_of(const Piece& piece) const {
    return {sources.data() + piece.first_source, piece.source_count};
  }
};

/// `pairs` are the intersecting pairs of soup faces, sorted. Throws InputError where there are some
/// and coordinates beyond 1e306.
Arrangement arrange(const std::shared_ptr<const Soup>& soup, const std::vector<FacePair>& pairs,
                    const Progress& progress);
}  // namespace transformesh
