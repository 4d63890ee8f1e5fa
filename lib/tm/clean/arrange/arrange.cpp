#include "tm/clean/arrange/arrange.h"

#include <algorithm>

#include "tm/clean/arrange/cut_plane.h"
#include "tm/clean/arrange/planar_triangulation.h"
#include "tm/mesh/disjoint_sets.h"
#include "tm/mesh/location_text.h"
#include "tm/support/error.h"
#include "tm/support/length.h"
#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr double largest_coordinate = 1e306;

// Planes of faces that are cut together, because they are coplanar and meet.
struct Planes {
  std::vector<std::vector<Index>> faces;              ///< of each plane, ascending; first copies
  std::vector<std::vector<const Meeting*>> meetings;  ///< of its faces with faces across it
  std::vector<Index> plane_of;                        ///< per welded face; no_index if whole
};

std::vector<Meeting> find_meetings(const WeldedMesh& welded, const std::vector<FacePair>& pairs) {
  std::vector<Meeting> meetings(pairs.size());
  parallel_for(pairs.size(), 256, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto [f, g] = pairs[i];
      meetings[i] = {f, g, find_contacts(welded, f, g)};
    }
  });
  return meetings;
}

Planes group_planes(const WeldedMesh& welded, const std::vector<Meeting>& meetings) {
  DisjointSets sets(welded.faces.size());
  std::vector<bool> is_cut(welded.faces.size(), false);
  for (const Meeting& meeting : meetings) {
    is_cut[meeting.first] = is_cut[meeting.second] = true;
    if (meeting.contacts.coplanar) sets.join(meeting.first, meeting.second);
  }
  for (Index f = 0; f < welded.faces.size(); ++f) {
    const Index first = welded.first_copy[f];
    if (first != f) is_cut[first] = is_cut[f] = true;
  }

  // The first face of a plane is the root of its set, so planes come in the order of their faces.
  Planes planes;
  planes.plane_of.assign(welded.faces.size(), no_index);
  for (Index f = 0; f < welded.faces.size(); ++f) {
    if (!is_cut[f]) continue;
    if (welded.first_copy[f] != f) {
      planes.plane_of[f] = planes.plane_of[welded.first_copy[f]];
      continue;
    }
    const Index root = sets.find(f);
    if (root == f) {
      planes.plane_of[f] = static_cast<Index>(planes.faces.size());
      planes.faces.emplace_back();
    } else {
      planes.plane_of[f] = planes.plane_of[root];
    }
    planes.faces[planes.plane_of[f]].push_back(f);
  }
  planes.meetings.resize(planes.faces.size());
  for (const Meeting& meeting : meetings) {
    if (meeting.contacts.coplanar) continue;
    planes.meetings[planes.plane_of[meeting.first]].push_back(&meeting);
    planes.meetings[planes.plane_of[meeting.second]].push_back(&meeting);
  }
  return planes;
}

std::vector<PlaneCut> cut_planes(const WeldedMesh& welded, const Planes& planes) {
  std::vector<PlaneCut> cuts(planes.faces.size());
  parallel_for(cuts.size(), 4, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      cuts[i] = cut_plane(welded, planes.faces[i], planes.meetings[i]);
    }
  });
  return cuts;
}

// Numbers the points of all planes. Equal points get one number; new points are numbered in the
// order in which the planes list them.
class PointUnifier {
 public:
  PointUnifier(const WeldedMesh& welded, std::vector<PlaneCut>& cuts);
  std::vector<std::vector<Index>> ids;  ///< per plane and point of it: the arrangement point
  std::vector<ExactPoint> cut_points;

 private:
  // A point of a plane that is no point of the mesh.
  struct Candidate {
    const ExactPoint* point;
    Index plane;
    Index local;  ///< its number in the plane
    Index order;  ///< its number among all candidates
  };
  std::vector<Candidate> collect(const std::vector<PlaneCut>& cuts);
  static void sort(const WeldedMesh& welded, std::vector<Candidate>& candidates);
};

std::vector<PointUnifier::Candidate> PointUnifier::collect(const std::vector<PlaneCut>& cuts) {
  std::vector<Candidate> candidates;
  ids.resize(cuts.size());
  for (Index plane = 0; plane < cuts.size(); ++plane) {
    const auto& points = cuts[plane].points;
    ids[plane].assign(points.size(), no_index);
    for (Index i = PlanarTriangulation::scaffold_points; i < points.size(); ++i) {
      if (points[i].kind == ExactPoint::Kind::given) {
        ids[plane][i] = points[i].definition[0];
      } else {
        candidates.push_back({&points[i], plane, i, static_cast<Index>(candidates.size())});
      }
    }
  }
  return candidates;
}

// Sorts candidates by position, and equal ones by their order. Equal definitions decide without
// arithmetic, so that exact comparisons are left to points that nearly coincide.
void PointUnifier::sort(const WeldedMesh& welded, std::vector<Candidate>& candidates) {
  const ExactGeometry geometry(welded.points, welded.faces);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](const Candidate& a, const Candidate& b) {
                     if (same_definition(*a.point, *b.point)) return false;
                     return geometry.compare(*a.point, *b.point) < 0;
                   });
}

PointUnifier::PointUnifier(const WeldedMesh& welded, std::vector<PlaneCut>& cuts) {
  std::vector<Candidate> candidates = collect(cuts);
  sort(welded, candidates);
  const ExactGeometry geometry(welded.points, welded.faces);

  // The first of each run of equal points stands for all of them.
  std::vector<Index> first(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const bool equal =
        i > 0 && (same_definition(*candidates[i].point, *candidates[i - 1].point) ||
                  geometry.compare(*candidates[i].point, *candidates[i - 1].point) == 0);
    first[candidates[i].order] = equal ? first[candidates[i - 1].order] : candidates[i].order;
  }
  std::vector<const Candidate*> by_order(candidates.size());
  for (const Candidate& candidate : candidates) by_order[candidate.order] = &candidate;
  for (Index order = 0; order < by_order.size(); ++order) {
    const Candidate& candidate = *by_order[order];
    const Candidate& representative = *by_order[first[order]];
    if (first[order] == order) {
      ids[candidate.plane][candidate.local] =
          static_cast<Index>(welded.points.size() + cut_points.size());
      cut_points.push_back(*candidate.point);
    } else {
      ids[candidate.plane][candidate.local] = ids[representative.plane][representative.local];
    }
  }
}

void add_whole_pieces(const WeldedMesh& welded, const Planes& planes, Arrangement& result) {
  for (Index f = 0; f < welded.faces.size(); ++f) {
    if (planes.plane_of[f] != no_index) continue;
    result.pieces.push_back({welded.faces[f], static_cast<Index>(result.sources.size()), 1, 1});
    result.sources.push_back({f, false});
  }
  result.whole_pieces = result.pieces.size();
}

// The faces that have the three points of another one, as sources in its place.
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

  /// Adds the copies of the sources from `begin` on, and keeps them in the order of the faces.
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
  std::vector<Index> next_;  ///< the next copy of each face
};

void add_cut_pieces(const PlaneCut& cut, const std::vector<Index>& ids, const Copies& copies,
                    Arrangement& result) {
  for (std::size_t i = 0; i < cut.facets.size(); ++i) {
    const Face& v = cut.facets[i];
    const auto first = static_cast<Index>(result.sources.size());
    result.sources.insert(result.sources.end(), cut.sources.begin() + cut.source_offsets[i],
                          cut.sources.begin() + cut.source_offsets[i + 1]);
    copies.add(result.sources, first);
    const auto count = static_cast<std::uint32_t>(result.sources.size() - first);
    Piece piece{{ids[v[0]], ids[v[1]], ids[v[2]]}, first, count, 0};
    for (const PieceSource& source : result.sources_of(piece)) {
      piece.multiplicity += source.reversed ? -1 : 1;
    }
    // A piece is oriented as most of its sources are.
    if (piece.multiplicity < 0) {
      piece.multiplicity = -piece.multiplicity;
      std::swap(piece.corners[1], piece.corners[2]);
      for (Index s = piece.first_source; s < result.sources.size(); ++s) {
        result.sources[s].reversed = !result.sources[s].reversed;
      }
    }
    result.pieces.push_back(piece);
  }
}

// Coplanar faces are cut within a triangle twelve times their size, which must not overflow.
void refuse_overflow(const WeldedMesh& welded) {
  for (const Vec3& point : welded.points) {
    if (point.cwiseAbs().maxCoeff() <= largest_coordinate) continue;
    throw InputError("the coordinates of " + point_text(point) +
                     " are too large to cut faces there: scale the mesh to below " +
                     shortest_text(largest_coordinate));
  }
}

}  // namespace

Arrangement arrange(const std::shared_ptr<const WeldedMesh>& welded,
                    const std::vector<FacePair>& pairs, const Progress& progress) {
  progress("arrange");
  if (!pairs.empty()) refuse_overflow(*welded);
  const std::vector<Meeting> meetings = find_meetings(*welded, pairs);
  const Planes planes = group_planes(*welded, meetings);
  std::vector<PlaneCut> cuts = cut_planes(*welded, planes);
  progress("arrange", 0.7);

  Arrangement result;
  result.welded = welded;
  PointUnifier unifier(*welded, cuts);
  result.cut_points = std::move(unifier.cut_points);
  add_whole_pieces(*welded, planes, result);
  const Copies copies(*welded);
  for (std::size_t i = 0; i < cuts.size(); ++i)
    add_cut_pieces(cuts[i], unifier.ids[i], copies, result);
  return result;
}

}  // namespace transformesh
