// Finds all pairs of intersecting faces of a mesh (paper 3.1). A bounding volume hierarchy finds
// pairs of overlapping boxes, and exact tests decide on each pair (contacts.h). Four steps exclude
// pairs before these tests. Faces near which there are only faces of their own intersection-free
// region are not searched (faces_to_search.h). Pairs of faces of one region are skipped
// (intersection_free_regions.h). Pairs that share a vertex with an embedded star are skipped
// (embedded_stars.h). Separating strips exclude pairs of long thin faces (face_strips.h). At
// vertices of high valence, pairs are found by angle instead of by boxes (high_valence_stars.h).
//
// Cost: O(n log n + k) for k pairs of overlapping boxes. Parallel; deterministic.
#include "transformesh/intersect.h"

#include <algorithm>

#include "clean/intersect/contacts.h"
#include "clean/intersect/embedded_stars.h"
#include "clean/intersect/face_strips.h"
#include "clean/intersect/faces_to_search.h"
#include "clean/intersect/find_meetings.h"
#include "clean/intersect/high_valence_stars.h"
#include "clean/intersect/intersection_free_regions.h"
#include "geometry/search/bvh.h"
#include "geometry/search/sort_pairs.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t faces_per_task = 4096;  ///< affects time only

// Returns the welded face of each mesh face, or no_index if the mesh face has no area.
std::vector<Index> welded_faces(const WeldedMesh& welded, std::size_t mesh_faces) {
  std::vector<Index> result(mesh_faces, no_index);
  for (Index f = 0; f < welded.faces.size(); ++f) result[welded.face_of[f]] = f;
  return result;
}

// Returns the bounding box of each face in floats. Rounding is monotonic, so the box can be merged
// from the rounded boxes of the three corners. Hence each point is rounded once.
std::vector<FloatBox> boxes_of(const WeldedMesh& welded, std::span<const Index> faces) {
  std::vector<FloatBox> around(welded.points.size());
  parallel_for(around.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p)
      around[p] = welded.frame.box(welded.points[p], welded.points[p]);
  });
  std::vector<FloatBox> boxes(faces.size());
  parallel_for(faces.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto& [a, b, c] = welded.faces[faces[i]];
      boxes[i] = around[a].merged(around[b]).merged(around[c]);
    }
  });
  return boxes;
}

// Returns for each face the list of all faces with the same three points (its copies), including
// itself, ascending. The list is stored at the first of the copies; the other copies have empty
// lists.
std::vector<std::vector<Index>> list_copies(const WeldedMesh& welded) {
  std::vector<std::vector<Index>> copies(welded.faces.size());
  for (Index f = 0; f < welded.faces.size(); ++f) copies[welded.first_copy[f]].push_back(f);
  return copies;
}

// Expands the pairs to coincident faces. In `pairs`, the first of several faces with the same three
// points stands for all of these faces (copies). The result lists the pairs for each copy, and also
// the pairs of copies of one face.
std::vector<FacePair> pairs_of_copies(const WeldedMesh& welded, std::vector<FacePair> pairs) {
  if (!welded.has_copies) return pairs;
  const auto copies = list_copies(welded);
  std::vector<FacePair> result;
  for (const auto& [f, g] : pairs) {
    for (const Index a : copies[f]) {
      for (const Index b : copies[g]) result.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  for (const auto& same : copies) {
    for (std::size_t i = 0; i < same.size(); ++i) {
      for (std::size_t j = i + 1; j < same.size(); ++j) result.emplace_back(same[i], same[j]);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

namespace {

std::vector<Index> regions_of(std::span<const Index> faces, std::span<const Index> regions) {
  std::vector<Index> result(faces.size());
  parallel_for(faces.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) result[i] = regions[faces[i]];
  });
  return result;
}

// Lists the pairs whose faces share no vertex with an embedded star. The loop has no branches
// because the outcome is unpredictable.
void list_others(const WeldedMesh& welded, std::span<const Index> faces,
                 const std::vector<char>& is_embedded, std::span<const Bvh::Pair> pairs,
                 std::vector<Bvh::Pair>& others) {
  others.resize(pairs.size());
  std::size_t count = 0;
  for (const auto& [i, k] : pairs) {
    others[count] = {i, k};
    count +=
        share_embedded_star(welded.faces[faces[i]], welded.faces[faces[k]], is_embedded) ? 0 : 1;
  }
  others.resize(count);
}

}  // namespace

namespace {

void add_meetings(const WeldedMesh& welded, std::span<const FacePair> pairs,
                  std::vector<Meeting>& meetings) {
  for (const auto& [f, g] : pairs) {
    const Contacts contacts = find_contacts(welded, f, g);
    if (contacts.meet) meetings.push_back({f, g, contacts});
  }
}

// Finds the intersecting pairs in which at least one face belongs to a star of high valence
// (high_valence_stars.h).
std::vector<std::vector<Meeting>> star_meetings(const WeldedMesh& welded,
                                                const HighValenceStars& stars,
                                                std::span<const Index> others,
                                                const std::vector<char>& is_embedded,
                                                const std::vector<Index>& regions) {
  std::vector<FacePair> pairs = stars.find_pairs(others);
  std::erase_if(pairs, [&](const FacePair& pair) {
    const auto [f, g] = pair;
    return (regions[f] != no_index && regions[f] == regions[g]) ||
           share_embedded_star(welded.faces[f], welded.faces[g], is_embedded);
  });
  std::vector<std::vector<Meeting>> lists(pairs.size() / faces_per_task + 1);
  parallel_for(pairs.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    add_meetings(welded, std::span(pairs).subspan(first, last - first),
                 lists[first / faces_per_task]);
  });
  return lists;
}

}  // namespace

namespace {

// Finds the intersecting pairs among the pairs with overlapping boxes. Pairs that share a vertex
// with an embedded star do not intersect, and are not tested.
std::vector<std::vector<Meeting>> box_meetings(const WeldedMesh& welded, const Bvh& bvh,
                                               std::span<const Index> faces,
                                               const std::vector<char>& is_embedded) {
  const FaceStrips strips(welded, faces);
  std::vector<std::vector<Meeting>> lists;
  bvh.visit_pairs([&](std::size_t count) { lists.resize(count); },
                  [&](std::size_t list, std::span<const Bvh::Pair> pairs) {
                    thread_local std::vector<Bvh::Pair> others;
                    list_others(welded, faces, is_embedded, pairs, others);
                    for (const auto& [i, k] : others) {
                      if (strips.are_apart(i, k)) continue;
                      const Contacts contacts = find_contacts(welded, faces[i], faces[k]);
                      if (contacts.meet) lists[list].push_back({faces[i], faces[k], contacts});
                    }
                  });
  return lists;
}

}  // namespace

namespace {

// Gives all faces of `disjoint` one region, because no two of them intersect. Points of other faces
// become seams.
void join_regions(const WeldedMesh& welded, const DisjointFaces& disjoint,
                  IntersectionFreeRegions& regions) {
  const auto joined = static_cast<Index>(welded.faces.size());  // other numbers are those of faces
  const std::vector<char> is_disjoint = disjoint.find(welded.points, welded.faces);
  for (Index f = 0; f < welded.faces.size(); ++f) {
    if (is_disjoint[f]) {
      regions.of_face[f] = joined;
    } else {
      for (const Index point : welded.faces[f]) regions.is_seam[point] = 1;
    }
  }
}

}  // namespace

std::vector<Meeting> find_meetings(const WeldedMesh& welded, const Progress& progress,
                                   const DisjointFaces& disjoint) {
  progress("intersect");
  IntersectionFreeRegions regions = find_intersection_free_regions(welded);
  if (!disjoint.empty()) join_regions(welded, disjoint, regions);
  RawVector<Index> faces = find_faces_to_search(welded, regions.of_face);
  const SimplexLinks links = find_simplex_links(welded.points, welded.faces);
  const std::vector<char> is_crowded = HighValenceStars::crowded_points(welded, links);
  // The list `is_crowded` is empty unless a point or an edge has so many faces that `links` exist
  // for it.
  for (std::size_t p = 0; p < is_crowded.size(); ++p) regions.is_seam[p] |= is_crowded[p];
  std::vector<char> is_embedded;
  HighValenceStars stars;
  Bvh bvh;
  const auto fill_bvh = [&] { bvh = Bvh(boxes_of(welded, faces), links, faces); };
  parallel_invoke(
      [&] {
        is_embedded = find_embedded_stars(welded, regions.is_seam);
        stars = HighValenceStars(welded, is_embedded, is_crowded);
      },
      [&] {
        if (is_crowded.empty()) fill_bvh();
      });
  if (!is_crowded.empty()) {
    std::erase_if(faces, [&](Index f) { return stars.has(f); });
    fill_bvh();
  }
  bvh.set_groups(regions_of(faces, regions.of_face));
  auto lists = box_meetings(welded, bvh, faces, is_embedded);
  if (!stars.empty())
    for (auto& list : star_meetings(welded, stars, faces, is_embedded, regions.of_face))
      lists.push_back(std::move(list));
  std::vector<Meeting> meetings = joined(lists);
  sort_pairs(meetings, welded.faces.size());
  return meetings;
}

std::size_t count_pairs(const WeldedMesh& welded, const std::vector<Meeting>& meetings) {
  if (!welded.has_copies) return meetings.size();
  std::vector<std::size_t> copies(welded.faces.size(), 0);
  for (const Index first : welded.first_copy) ++copies[first];
  std::size_t count = 0;
  for (const Meeting& meeting : meetings) count += copies[meeting.first] * copies[meeting.second];
  for (const std::size_t same : copies) count += same * (same - (same > 0 ? 1 : 0)) / 2;
  return count;
}

std::vector<Meeting> meetings_of(const WeldedMesh& welded, std::span<const FacePair> pairs) {
  const auto first_copy = [&](Index face) {
    const auto at = std::lower_bound(welded.face_of.begin(), welded.face_of.end(), face);
    return welded.first_copy[static_cast<std::size_t>(at - welded.face_of.begin())];
  };
  std::vector<FacePair> firsts;
  for (const auto& [a, b] : pairs) {
    const auto [f, g] = std::minmax({first_copy(a), first_copy(b)});
    if (f != g) firsts.emplace_back(f, g);
  }
  std::sort(firsts.begin(), firsts.end());
  firsts.erase(std::unique(firsts.begin(), firsts.end()), firsts.end());
  std::vector<Meeting> meetings;
  add_meetings(welded, firsts, meetings);
  return meetings;
}

std::vector<FacePair> find_intersections(const Mesh& mesh, const Progress& progress) {
  return find_intersections(mesh, {}, progress);
}

std::vector<FacePair> find_intersections(const Mesh& mesh, const DisjointFaces& disjoint,
                                         const Progress& progress) {
  const WeldedMesh welded = weld(mesh);
  std::vector<FacePair> pairs;
  for (const Meeting& meeting : find_meetings(welded, progress, disjoint))
    pairs.emplace_back(meeting.first, meeting.second);
  pairs = pairs_of_copies(welded, std::move(pairs));
  // Welded faces are in the order of the mesh faces, so the pairs stay sorted.
  for (auto& [f, g] : pairs) {
    f = welded.face_of[f];
    g = welded.face_of[g];
  }
  return pairs;
}

std::vector<std::pair<Vec3, Vec3>> intersection_segments(const Mesh& mesh,
                                                         const std::vector<FacePair>& pairs) {
  const WeldedMesh welded = weld(mesh);
  const std::vector<Index> of_mesh = welded_faces(welded, mesh.faces.size());
  const ExactGeometry geometry(welded.points, welded.faces);
  std::vector<std::pair<Vec3, Vec3>> segments;
  for (const auto& [f, g] : pairs) {
    const Index a = of_mesh[f], b = of_mesh[g];
    const Contacts contacts = find_contacts(welded, a, b);
    if (!contacts.meet || contacts.coplanar) continue;
    const auto at = [&](int i) {
      return contact_point(welded, geometry, a, b, contacts.contacts[static_cast<std::size_t>(i)])
          .center;
    };
    segments.emplace_back(at(0), at(contacts.count - 1));
  }
  return segments;
}

}  // namespace transformesh
