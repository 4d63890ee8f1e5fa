/// The exact arrangement of a mesh with itself (paper 3.2.3): every face that takes part in an
/// intersection is cut along all others, so that pieces meet only in equal corners and equal edges.
/// Faces that take no part stay whole. Coplanar faces that meet are cut together, and where they
/// overlap they share one piece. The faces that cover a piece are its sources.
#pragma once

#include <memory>
#include <span>

#include "clean/arrange/cut_plane.h"
#include "clean/intersect/welded_mesh.h"
#include "geometry/numbers/exact_point.h"
#include "transformesh/control.h"
#include "transformesh/intersect.h"

namespace transformesh {

struct Piece {
  Face corners;        ///< arrangement points
  Index first_source;  ///< its sources are [first_source, first_source + source_count)
  std::uint32_t source_count;
  std::int32_t multiplicity;  ///< sources less reversed sources: by how much w grows from front to
                              ///< back; never negative, and 0 where the sources cancel out
  bool is_open = false;       ///< its sources are faces of open components; else they are closed
  std::int32_t front = 0;     ///< the winding number of the closed part in front, if it is known
};

struct Arrangement {
  std::shared_ptr<const WeldedMesh> welded;
  std::vector<ExactPoint> cut_points;  ///< point i is cut_points[i - welded->points.size()]
  std::vector<Piece> pieces;           ///< whole faces in their order, then those of cut faces
  std::vector<PieceSource> sources;
  std::size_t whole_pieces = 0;

  ExactGeometry geometry() const { return {welded->points, welded->faces}; }
  ExactPoint point(Index i) const {
    return i < welded->points.size() ? geometry().given(i) : cut_points[i - welded->points.size()];
  }
  /// In doubles, within one unit in the last place.
  Vec3 position(Index i) const {
    return i < welded->points.size() ? welded->points[i]
                                     : geometry().position(cut_points[i - welded->points.size()]);
  }
  std::size_t point_count() const { return welded->points.size() + cut_points.size(); }
  std::span<const PieceSource> sources_of(const Piece& piece) const {
    return {sources.data() + piece.first_source, piece.source_count};
  }
};

/// Turns a piece of the arrangement around.
void reverse_piece(Arrangement& arrangement, Piece& piece);

/// `meetings` are those of the intersecting pairs of welded faces, sorted, without those of copies,
/// which are cut as one: the work does not grow with their number, but for the sources. Throws as
/// refuse_overflow does. Parallel; deterministic for any number of threads.
Arrangement arrange(const std::shared_ptr<const WeldedMesh>& welded,
                    const std::vector<Meeting>& meetings, const Progress& progress);

/// The arrangement of planes that are cut. Whole faces may be left out.
Arrangement join_cuts(const std::shared_ptr<const WeldedMesh>& welded, const Planes& planes,
                      const std::vector<PlaneCut>& cuts, const std::vector<char>& is_left_out = {});

/// Throws InputError where a coordinate is beyond 1e306.
void refuse_overflow(const WeldedMesh& welded);

}  // namespace transformesh
