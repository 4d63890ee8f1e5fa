#include "clean/arrange/arrange.h"

#include <algorithm>

#include "clean/arrange/unify_points.h"
#include "mesh/location_text.h"
#include "support/number.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/length.h"

namespace transformesh {
namespace {

// A plane is triangulated inside a scaffold triangle whose corners reach 12 times the extent of the
// coplanar faces. With this limit, the coordinates of the scaffold do not overflow.
constexpr double largest_coordinate = 1e306;
constexpr std::size_t planes_per_task = 4;  ///< planes cut in one task; affects time only

// Reserves room for all pieces, and for all sources except copies. Reallocation takes longer than
// adding the entries.
void reserve_pieces(const WeldedMesh& welded, const std::vector<PlaneCut>& cuts,
                    Arrangement& result) {
  std::size_t pieces = welded.faces.size(), sources = pieces;
  for (const PlaneCut& cut : cuts) {
    pieces += cut.facets.size();
    sources += cut.sources.size();
  }
  result.pieces.reserve(pieces);
  result.sources.reserve(sources);
}

void add_whole_pieces(const WeldedMesh& welded, const Planes& planes,
                      const std::vector<char>& is_left_out, Arrangement& result) {
  for (Index f = 0; f < welded.faces.size(); ++f) {
    if (!planes.is_whole(f) || (!is_left_out.empty() && is_left_out[f])) continue;
    result.pieces.push_back({welded.faces[f], static_cast<Index>(result.sources.size()), 1, 1});
    result.sources.push_back({f, false});
  }
  result.whole_pieces = result.pieces.size();
}

// Lists the copies of each face (faces with the same three points), to add them as sources.
class Copies {
 public:
  explicit Copies(const WeldedMesh& welded)
      : welded_(welded), next_(welded.faces.size(), no_index) {
    std::vector<Index> last(welded.faces.size(), no_index);
    for (Index f = 0; f < welded.faces.size(); ++f) {
      const Index first = welded.first_copy[f];
      if (first != f) next_[last[first]] = f;
      last[first] = f;
    }
  }

  /// Adds the copies of the sources at `begin` and after; sorts the sources from `begin` on by
  /// face.
  void add(std::vector<PieceSource>& sources, std::size_t begin) const {
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
  std::vector<Index> next_;  ///< index of the next copy of each face, or no_index
};

// Adds the sources of a facet: only open faces for an open piece, only closed faces for a closed
// one.
void add_sources(const PlaneCut& cut, std::size_t facet, const Copies& copies, bool is_open,
                 Arrangement& result) {
  const std::size_t first = result.sources.size();
  result.sources.insert(result.sources.end(), cut.sources.begin() + cut.source_offsets[facet],
                        cut.sources.begin() + cut.source_offsets[facet + 1]);
  copies.add(result.sources, first);
  if (result.welded->open_component.empty()) return;
  const auto is_other = [&](const PieceSource& source) {
    return result.welded->is_open(source.face) != is_open;
  };
  result.sources.erase(std::remove_if(result.sources.begin() + static_cast<std::ptrdiff_t>(first),
                                      result.sources.end(), is_other),
                       result.sources.end());
}

void add_cut_pieces(const PlaneCut& cut, const std::vector<Index>& ids, const Copies& copies,
                    Arrangement& result) {
  for (std::size_t i = 0; i < cut.facets.size(); ++i) {
    const Face& v = cut.facets[i];
    const OpenFacet open = cut.open.empty() ? OpenFacet{false, 0} : cut.open[i];
    const auto first = static_cast<Index>(result.sources.size());
    add_sources(cut, i, copies, open.is_open, result);
    const auto count = static_cast<std::uint32_t>(result.sources.size() - first);
    Piece piece{{ids[v[0]], ids[v[1]], ids[v[2]]}, first, count, 0, open.is_open, open.front};
    for (const PieceSource& source : result.sources_of(piece)) {
      piece.multiplicity += source.reversed ? -1 : 1;
    }
    // Orient the piece like the majority of its sources.
    if (piece.multiplicity < 0) {
      piece.multiplicity = -piece.multiplicity;
      reverse_piece(result, piece);
    }
    result.pieces.push_back(piece);
  }
}

}  // namespace

void reverse_piece(Arrangement& arrangement, Piece& piece) {
  std::swap(piece.corners[1], piece.corners[2]);
  for (std::uint32_t s = 0; s < piece.source_count; ++s) {
    bool& is_reversed = arrangement.sources[piece.first_source + s].reversed;
    is_reversed = !is_reversed;
  }
}

void refuse_overflow(const WeldedMesh& welded) {
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
  reserve_pieces(*welded, cuts, result);
  add_whole_pieces(*welded, planes, is_left_out, result);
  const Copies copies(*welded);
  for (std::size_t i = 0; i < cuts.size(); ++i)
    add_cut_pieces(cuts[i], unified.ids[i], copies, result);
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
