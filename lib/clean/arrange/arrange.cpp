#include "clean/arrange/arrange.h"

#include <algorithm>

#include "clean/arrange/unify_points.h"
#include "mesh/location_text.h"
#include "support/number.h"
#include "support/numbered_selection.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/length.h"

namespace transformesh {
namespace {

// Largest accepted coordinate. Coplanar faces are triangulated inside a large auxiliary triangle
// (scaffold), whose corners are at about 12 times the extent of the faces. With this limit, the
// coordinates of the scaffold do not overflow.
constexpr double largest_coordinate = 1e306;
constexpr std::size_t points_per_task = 64;    ///< points evaluated in one task; affects time only
constexpr std::size_t planes_per_task = 4;     ///< planes cut in one task; affects time only
constexpr std::size_t planes_per_block = 512;  ///< planes joined in one task; affects time only

// Adds the faces without intersections as pieces. Reserves memory for all pieces, and for their
// sources (faces that contain a piece). Copies (faces with the same three points as an earlier
// face) are not counted.
void add_whole_pieces(const WeldedMesh& welded, const Planes& planes,
                      const std::vector<PlaneCut>& cuts, const std::vector<char>& is_left_out,
                      Arrangement& result) {
  std::size_t cut_pieces = 0, cut_sources = 0;
  for (const PlaneCut& cut : cuts) {
    cut_pieces += cut.facets.size();
    cut_sources += cut.sources.size();
  }
  const NumberedSelection whole(welded.faces.size(), [&](std::size_t f) {
    return planes.is_whole(static_cast<Index>(f)) && (is_left_out.empty() || !is_left_out[f]);
  });
  result.whole_pieces = whole.size();
  result.pieces.reserve(whole.size() + cut_pieces);
  result.sources.reserve(whole.size() + cut_sources);
  result.pieces.resize(whole.size());
  result.sources.resize(whole.size());
  whole.visit([&](std::size_t f, std::size_t p) {
    result.pieces[p] = {welded.faces[f], static_cast<Index>(p), 1, 1, false, 0};
    result.sources[p] = {static_cast<Index>(f), false};
  });
}

// Lists the copies of each face (faces with the same three points). They are sources of a piece
// too: faces that contain it.
class Copies {
 public:
  explicit Copies(const WeldedMesh& welded) : welded_(welded) {
    if (!welded.has_copies) return;
    next_.assign(welded.faces.size(), no_index);
    std::vector<Index> last(welded.faces.size(), no_index);
    for (Index f = 0; f < welded.faces.size(); ++f) {
      const Index first = welded.first_copy[f];
      if (first != f) next_[last[first]] = f;
      last[first] = f;
    }
  }

  /// For each source (face that contains a piece) at `begin` or later, appends the faces with the
  /// same three points as sources. Then sorts all sources at `begin` or later by face.
  void add(RawVector<PieceSource>& sources, std::size_t begin) const {
    if (next_.empty()) return;
    const std::size_t end = sources.size();
    for (std::size_t s = begin; s < end; ++s) {
      const PieceSource source = sources[s];
      for (Index copy = next_[source.face]; copy != no_index; copy = next_[copy]) {
        sources.push_back({copy, source.reversed != is_reversed(source.face, copy)});
      }
    }
    if (sources.size() == end) return;
    std::sort(sources.begin() + static_cast<std::ptrdiff_t>(begin), sources.end(),
              [](const PieceSource& a, const PieceSource& b) { return a.face < b.face; });
  }

 private:
  bool is_reversed(Index face, Index copy) const {
    const Face &f = welded_.faces[face], &c = welded_.faces[copy];
    const auto at = static_cast<std::size_t>(std::find(c.begin(), c.end(), f[0]) - c.begin());
    return c[(at + 1) % 3] != f[1];
  }

  const WeldedMesh& welded_;
  /// Next face with the same three points as each face, or no_index; empty if there are no copies.
  std::vector<Index> next_;
};

/// Pieces of the faces in a block of consecutive planes, and the sources of the pieces (faces that
/// contain them). Piece::first_source is an index in `sources` of this object.
struct CutPieces {
  RawVector<Piece> pieces;
  RawVector<PieceSource> sources;
};

// Adds the sources of a piece (the faces that contain the facet). An open piece gets only sources
// that belong to open components; a closed piece gets the others.
void add_sources(const WeldedMesh& welded, const PlaneCut& cut, std::size_t facet,
                 const Copies& copies, bool is_open, RawVector<PieceSource>& sources) {
  const std::size_t first = sources.size();
  sources.insert(sources.end(), cut.sources.begin() + cut.source_offsets[facet],
                 cut.sources.begin() + cut.source_offsets[facet + 1]);
  copies.add(sources, first);
  if (welded.open_component.empty()) return;
  const auto is_other = [&](const PieceSource& source) {
    return welded.is_open(source.face) != is_open;
  };
  sources.erase(
      std::remove_if(sources.begin() + static_cast<std::ptrdiff_t>(first), sources.end(), is_other),
      sources.end());
}

// Reverses the orientation of a piece. Inverts the `reversed` flags of `sources`, the faces that
// contain the piece.
void reverse(Piece& piece, std::span<PieceSource> sources) {
  std::swap(piece.corners[1], piece.corners[2]);
  for (PieceSource& source : sources) source.reversed = !source.reversed;
}

void add_cut_pieces(const WeldedMesh& welded, const PlaneCut& cut, const std::vector<Index>& ids,
                    const Copies& copies, CutPieces& result) {
  for (std::size_t i = 0; i < cut.facets.size(); ++i) {
    const Face& v = cut.facets[i];
    const OpenFacet open = cut.open.empty() ? OpenFacet{false, 0} : cut.open[i];
    const std::size_t first = result.sources.size();
    add_sources(welded, cut, i, copies, open.is_open, result.sources);
    const std::span<PieceSource> sources = std::span(result.sources).subspan(first);
    Piece piece{{ids[v[0]], ids[v[1]], ids[v[2]]},
                static_cast<Index>(first),
                static_cast<std::uint32_t>(sources.size()),
                0,
                open.is_open,
                open.front};
    for (const PieceSource& source : sources) piece.multiplicity += source.reversed ? -1 : 1;
    // Orient the piece like the majority of the faces that contain it.
    if (piece.multiplicity < 0) {
      piece.multiplicity = -piece.multiplicity;
      reverse(piece, sources);
    }
    result.pieces.push_back(piece);
  }
}

// Appends the pieces of all blocks, and the faces that contain the pieces (sources).
void append(const std::vector<CutPieces>& blocks, Arrangement& result) {
  struct Place {
    std::size_t piece, source;
  };
  std::vector<Place> places;
  Place next{result.pieces.size(), result.sources.size()};
  for (const CutPieces& block : blocks) {
    places.push_back(next);
    next.piece += block.pieces.size();
    next.source += block.sources.size();
  }
  result.pieces.resize(next.piece);
  result.sources.resize(next.source);
  parallel_for(blocks.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t b = first; b < last; ++b) {
      std::copy(blocks[b].sources.begin(), blocks[b].sources.end(),
                result.sources.begin() + static_cast<std::ptrdiff_t>(places[b].source));
      Piece* piece = result.pieces.data() + places[b].piece;
      for (const Piece& of_block : blocks[b].pieces) {
        *piece = of_block;
        piece++->first_source += static_cast<Index>(places[b].source);
      }
    }
  });
}

// Each point is evaluated by one thread only, because its exact coordinates are kept in it.
RawVector<Vec3> positions_of(const ExactGeometry& geometry, std::span<const ExactPoint> points) {
  RawVector<Vec3> positions(points.size());
  parallel_for(points.size(), points_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) positions[i] = geometry.position(points[i]);
  });
  return positions;
}

}  // namespace

void reverse_piece(Arrangement& arrangement, Piece& piece) {
  reverse(piece, std::span(arrangement.sources).subspan(piece.first_source, piece.source_count));
}

void refuse_overflow(const WeldedMesh& welded) {
  const NumberedSelection large(welded.points.size(), [&](std::size_t p) {
    return !(welded.points[p].cwiseAbs().maxCoeff() <= largest_coordinate);
  });
  if (large.size() == 0) return;
  for (const Vec3& point : welded.points) {
    if (point.cwiseAbs().maxCoeff() <= largest_coordinate) continue;
    throw InputError(ErrorKind::coordinates_too_large,
                     "the coordinates of " + point_text(point) +
                         " are too large to cut faces there: scale the mesh to below " +
                         shortest_text(largest_coordinate),
                     {.position = position_data(point), .lengths = {largest_coordinate}});
  }
}

Arrangement join_cuts(const std::shared_ptr<const WeldedMesh>& welded, const Planes& planes,
                      const std::vector<PlaneCut>& cuts, const std::vector<char>& is_left_out) {
  Arrangement result;
  result.welded = welded;
  UnifiedPoints unified = unify_points(*welded, cuts);
  result.cut_points = std::move(unified.cut_points);
  result.cut_positions = positions_of(result.geometry(), result.cut_points);
  add_whole_pieces(*welded, planes, cuts, is_left_out, result);
  const Copies copies(*welded);
  std::vector<CutPieces> blocks((cuts.size() + planes_per_block - 1) / planes_per_block);
  parallel_for(blocks.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t b = first; b < last; ++b)
      for (std::size_t i = b * planes_per_block; i < (b + 1) * planes_per_block; ++i)
        if (i < cuts.size()) add_cut_pieces(*welded, cuts[i], unified.ids[i], copies, blocks[b]);
  });
  append(blocks, result);
  return result;
}

Arrangement arrange(const std::shared_ptr<const WeldedMesh>& welded,
                    const std::vector<Meeting>& meetings, const Progress& progress) {
  progress("arrange");
  if (!meetings.empty()) refuse_overflow(*welded);
  const Planes planes(*welded, meetings);
  std::vector<PlaneCut> cuts(planes.size());
  parallel_for(cuts.size(), planes_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) cuts[i] = cut_plane(*welded, planes[i]);
  });
  progress("arrange", 0.7);
  return join_cuts(welded, planes, cuts);
}

}  // namespace transformesh
