/// Exact arrangement of a mesh with itself (paper 3.2.3). Each face that takes part in an
/// intersection is cut along all faces that it meets. Afterwards pieces meet only in equal corners
/// and equal edges. Faces that take part in no intersection stay whole. A piece is a triangle of a
/// cut face, or a whole face. Coplanar faces that meet are cut together, and share one piece where
/// they overlap. The sources of a piece are the faces that contain it. A face, or a set of coplanar
/// faces that meet, is called a plane. Planes are cut independently of each other; `cut_plane.h`
/// has the cost of one plane.
#pragma once

#include <memory>
#include <span>

#include "clean/arrange/cut_plane.h"
#include "clean/intersect/welded_mesh.h"
#include "geometry/numbers/exact_point.h"
#include "support/raw_vector.h"
#include "transformesh/control.h"
#include "transformesh/intersect.h"

namespace transformesh {

struct Piece {
  Face corners;  ///< corners of the piece, as indices of arrangement points
  /// Index in `Arrangement::sources` of the first face that contains the piece.
  Index first_source;
  std::uint32_t source_count;
  /// Number of sources (faces that contain the piece) with the orientation of the piece, minus the
  /// number of reversed ones. The winding number grows by this amount from front to back. It is >=
  /// 0; 0 if the sources cancel out.
  std::int32_t multiplicity;
  /// True if faces of open components contain the piece, false for the closed part of the mesh.
  bool is_open;
  /// Winding number of the closed part of the mesh (open/open_components.h) in front of the piece.
  /// Only arrange_exterior() sets it: for whole faces, and for all pieces if the mesh has open
  /// components.
  std::int32_t front;
};

struct Arrangement {
  std::shared_ptr<const WeldedMesh> welded;
  /// Points that cutting created; the first has the index `welded->points.size()`.
  std::vector<ExactPoint> cut_points;
  /// Positions of these points in doubles, within one unit in the last place. Threads may read them
  /// at the same time, but must not evaluate the same exact point.
  RawVector<Vec3> cut_positions;
  RawVector<Piece> pieces;  ///< whole faces in mesh order, then the pieces of cut faces
  RawVector<PieceSource> sources;
  std::size_t whole_pieces = 0;

  ExactGeometry geometry() const { return {welded->points, welded->faces}; }
  ExactPoint point(Index i) const {
    return i < welded->points.size() ? geometry().given(i) : cut_points[i - welded->points.size()];
  }
  const Vec3& position(Index i) const {
    return i < welded->points.size() ? welded->points[i] : cut_positions[i - welded->points.size()];
  }
  std::size_t point_count() const { return welded->points.size() + cut_points.size(); }
  std::span<const PieceSource> sources_of(const Piece& piece) const {
    return {sources.data() + piece.first_source, piece.source_count};
  }
};

/// Reverses the orientation of a piece. Inverts the `reversed` flags of the faces that contain the
/// piece (sources).
void reverse_piece(Arrangement& arrangement, Piece& piece);

/// Cuts the welded faces along `meetings`, the sorted intersections of all pairs of faces. If
/// several faces have the same three points (copies), only the first of them has meetings, and all
/// are cut together with it. Hence copies add to the number of sources, but not to the cutting
/// work. Throws what refuse_overflow() throws. Parallel; deterministic for any number of threads.
Arrangement arrange(const std::shared_ptr<const WeldedMesh>& welded,
                    const std::vector<Meeting>& meetings, const Progress& progress);

/// Joins the pieces of all planes and the faces without intersections to one arrangement. Faces
/// without intersections are omitted if their `is_left_out` entry is nonzero.
Arrangement join_cuts(const std::shared_ptr<const WeldedMesh>& welded, const Planes& planes,
                      const std::vector<PlaneCut>& cuts, const std::vector<char>& is_left_out = {});

/// Throws InputError if the absolute value of a coordinate exceeds 1e306.
void refuse_overflow(const WeldedMesh& welded);

}  // namespace transformesh
