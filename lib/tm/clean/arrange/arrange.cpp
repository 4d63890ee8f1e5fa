#include "tm/clean/arrange/arrange.h"

#include <algorithm>

#include "tm/clean/arrange/cut_plane.h"
#include "tm/mesh/disjoint_sets.h"
#include "tm/mesh/location_text.h"
#include "tm/support/error.h"
#include "tm/support/length.h"
#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr double largest_coordinate = 1e306;

// The faces that are cut together: coplanar ones that meet.
struct Planes {
  std::vector<std::vector<Index>> faces;
  std::vector<std::vector<const Meeting*>> meetings;
  std::vector<Index> plane_of;  ///< of each soup face; no_index for whole faces
};

std::vector<Meeting> find_meetings(const Soup& soup, const std::vector<FacePair>& pairs) {
  std::vector<Meeting> meetings(pairs.size());
  parallel_for(pairs.size(), 256, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto [f, g] = pairs[i];
      meetings[i] = {f, g, find_contacts(soup, f, g)};
    }
  });
  return meetings;
}

Planes group_planes(const Soup& soup, const std::vector<Meeting>& meetings) {
  DisjointSets sets(soup.faces.size());
  std::vector<bool> is_cut(soup.faces.size(), false);
  for (const Meeting& meeting : meetings) {
    is_cut[meeting.first] = is_cut[meeting.second] = true;
    if (meeting.contacts.coplanar) sets.join(meeting.first, meeting.second);
  }

  // Planes in order of their first face, which is their root.
  Planes planes;
  planes.plane_of.assign(soup.faces.size(), no_index);
  for (Index f = 0; f < soup.faces.size(); ++f) {
    if (!is_cut[f]) continue;
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

std::vector<PlaneCut> cut_planes(const Soup& soup, const Planes& planes) {
  std::vector<PlaneCut> cuts(planes.faces.size());
  parallel_for(cuts.size(), 4, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      cuts[i] = cut_plane(soup, planes.faces[i], planes.meetings[i]);
    }
  });
  return cuts;
}

bool same_definition(const ExactPoint& a, const ExactPoint& b) {
  return a.kind == b.kind && a.definition == b.definition;
}

// Numbers the points of all planes, equal points alike, new ones in order of appearance.
class PointUnifier {
 public:
  PointUnifier(const Soup& soup, std::vector<PlaneCut>& cuts);
  /// The arrangement points of one plane's points.
  std::vector<std::vector<Index>> ids;
  std::vector<ExactPoint> cut_points;

 private:
  struct Candidate {
    const ExactPoint* point;
    Index plane;
    Index local;
    Index order;
  };
  std::vector<Candidate> collect(const std::vector<PlaneCut>& cuts);
  static void sort(const Soup& soup, std::vector<Candidate>& candidates);
};

std::vector<PointUnifier::Candidate> PointUnifier::collect(const std::vector<PlaneCut>& cuts) {
  std::vector<Candidate> candidates;
  ids.resize(cuts.size());
  for (Index plane = 0; plane < cuts.size(); ++plane) {
    const auto& points = cuts[plane].points;
    ids[plane].assign(points.size(), no_index);
    for (Index i = 3; i < points.size(); ++i) {  // the first three are scaffold
      if (points[i].kind == ExactPoint::Kind::given) {
        ids[plane][i] = points[i].definition[0];
      } else {
        candidates.push_back({&points[i], plane, i, static_cast<Index>(candidates.size())});
      }
    }
  }
  return candidates;
}

// By position; equal positions in order of appearance. Points of one definition are brought
// together first, so that exact comparisons are left to points that nearly coincide.
void PointUnifier::sort(const Soup& soup, std::vector<Candidate>& candidates) {
  const ExactGeometry geometry(soup.points, soup.faces);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](const Candidate& a, const Candidate& b) {
                     if (same_definition(*a.point, *b.point)) return false;
                     return geometry.compare(*a.point, *b.point) < 0;
                   });
}

PointUnifier::PointUnifier(const Soup& soup, std::vector<PlaneCut>& cuts) {
  std::vector<Candidate> candidates = collect(cuts);
  sort(soup, candidates);
  const ExactGeometry geometry(soup.points, soup.faces);

  // Each run of equal points is known by its first appearance.
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
          static_cast<Index>(soup.points.size() + cut_points.size());
      cut_points.push_back(*candidate.point);
    } else {
      ids[candidate.plane][candidate.local] = ids[representative.plane][representative.local];
    }
  }
}

void add_whole_pieces(const Soup& soup, const Planes& planes, Arrangement& result) {
  for (Index f = 0; f < soup.faces.size(); ++f) {
    if (planes.plane_of[f] != no_index) continue;
    result.pieces.push_back({soup.faces[f], static_cast<Index>(result.sources.size()), 1, 1});
    result.sources.push_back({f, false});
  }
  result.whole_pieces = result.pieces.size();
}

void add_cut_pieces(const PlaneCut& cut, const std::vector<Index>& ids, Arrangement& result) {
  for (std::size_t i = 0; i < cut.facets.size(); ++i) {
    const Face& v = cut.facets[i];
    const Index begin = cut.source_offsets[i];
    const Index end = cut.source_offsets[i + 1];
    Piece piece{{ids[v[0]], ids[v[1]], ids[v[2]]},
                static_cast<Index>(result.sources.size()),
                end - begin,
                0};
    for (Index s = begin; s < end; ++s) {
      result.sources.push_back(cut.sources[s]);
      piece.winding += cut.sources[s].reversed ? -1 : 1;
    }
    // Every piece looks the way most of its sources do.
    if (piece.winding < 0) {
      piece.winding = -piece.winding;
      std::swap(piece.corners[1], piece.corners[2]);
      for (Index s = piece.first_source; s < result.sources.size(); ++s) {
        result.sources[s].reversed = !result.sources[s].reversed;
      }
    }
    result.pieces.push_back(piece);
  }
}

// Coplanar faces are cut within a triangle twelve times their size.
void refuse_overflow(const Soup& soup) {
  for (const Vec3& point : soup.points) {
    if (point.cwiseAbs().maxCoeff() <= largest_coordinate) continue;
    throw InputError("the coordinates of " + point_text(point) +
                     " are too large to cut faces there: scale the mesh to below " +
                     shortest_text(largest_coordinate));
  }
}

}  // namespace

Arrangement arrange(const std::shared_ptr<const Soup>& soup, const std::vector<FacePair>& pairs,
                    const Progress& progress) {
  progress("arrange");
  if (!pairs.empty()) refuse_overflow(*soup);
  const std::vector<Meeting> meetings = find_meetings(*soup, pairs);
  const Planes planes = group_planes(*soup, meetings);
  std::vector<PlaneCut> cuts = cut_planes(*soup, planes);
  progress("arrange", 0.7);

  Arrangement result;
  result.soup = soup;
  PointUnifier unifier(*soup, cuts);
  result.cut_points = std::move(unifier.cut_points);
  add_whole_pieces(*soup, planes, result);
  for (std::size_t i = 0; i < cuts.size(); ++i) add_cut_pieces(cuts[i], unifier.ids[i], result);
  return result;
}

}  // namespace transformesh
