#include "clean/rounding/broken_faces.h"

#include <algorithm>
#include <array>

#include "clean/intersect/find_meetings.h"
#include "clean/intersect/welded_mesh.h"
#include "geometry/numbers/predicates.h"
#include "geometry/search/bvh.h"
#include "mesh/disjoint_sets.h"
#include "mesh/mesh_of_faces.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t faces_per_task = 4096;  ///< affects time only

FloatBox box_of(const Mesh& mesh, const BoxFrame& frame, Index face) {
  const Triangle t = triangle_of(mesh.positions, mesh.faces[face]);
  return frame.box(t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2]));
}

std::vector<char> find_faces_at_new_ones(const Assembly& assembly) {
  const Mesh& mesh = assembly.mesh;
  std::vector<Vec3> corners;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (!assembly.face_is_new[f]) continue;
    for (const Index v : mesh.faces[f]) corners.push_back(mesh.positions[v]);
  }
  const BoxFrame frame(corners);
  std::vector<FloatBox> boxes;
  for (Index f = 0; f < mesh.faces.size(); ++f)
    if (assembly.face_is_new[f]) boxes.push_back(box_of(mesh, frame, f));
  const Bvh bvh(boxes);

  std::vector<char> is_near = assembly.face_is_new;
  const auto note = [](char& mark) { return [&](Index) { return mark = 1, false; }; };
  if (boxes.empty()) return is_near;
  parallel_for(is_near.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f)
      if (!is_near[f])
        bvh.visit_overlaps(box_of(mesh, frame, static_cast<Index>(f)), note(is_near[f]));
  });
  return is_near;
}

std::vector<Index> marked(const std::vector<char>& marks) {
  std::vector<Index> result;
  for (Index i = 0; i < marks.size(); ++i) {
    if (marks[i]) result.push_back(i);
  }
  return result;
}

/// The corners of a face in ascending order, with the orientation that the sorting lost.
struct UnorderedFace {
  std::array<Index, 3> corners;
  bool is_even;  ///< true if the sorted corners have the orientation of the face
  Index face;
  auto key() const { return std::tie(corners, is_even, face); }
};

UnorderedFace unordered(const Face& face, Index index) {
  std::array<Index, 3> corners = {face[0], face[1], face[2]};
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  const bool is_even = corners[1] < corners[2];
  if (!is_even) std::swap(corners[1], corners[2]);
  return {corners, is_even, index};
}

// Returns the faces of which all corners are corners of new faces (faces that are not whole input
// faces), sorted by corners.
std::vector<UnorderedFace> sorted_faces_at_new_ones(const Assembly& assembly) {
  const std::vector<Face>& faces = assembly.mesh.faces;
  std::vector<char> is_at_new(assembly.mesh.positions.size(), 0);
  for (Index f = 0; f < faces.size(); ++f) {
    if (!assembly.face_is_new[f]) continue;
    for (const Index v : faces[f]) is_at_new[v] = 1;
  }
  std::vector<UnorderedFace> sorted;
  for (Index f = 0; f < faces.size(); ++f) {
    const auto& [a, b, c] = faces[f];
    if (is_at_new[a] && is_at_new[b] && is_at_new[c]) sorted.push_back(unordered(faces[f], f));
  }
  std::sort(sorted.begin(), sorted.end(),
            [](const UnorderedFace& a, const UnorderedFace& b) { return a.key() < b.key(); });
  return sorted;
}

// Sets the `keep` entries of pairs of faces with equal corners and opposite orientation to 0.
void cancel_opposite_faces(const Assembly& assembly, std::vector<char>& keep) {
  const std::vector<UnorderedFace> sorted = sorted_faces_at_new_ones(assembly);
  for (std::size_t first = 0, last = 0; first < sorted.size(); first = last) {
    std::size_t odd = 0;
    for (last = first; last < sorted.size() && sorted[last].corners == sorted[first].corners;
         ++last)
      odd += sorted[last].is_even ? 0 : 1;
    const std::size_t pairs = std::min(odd, last - first - odd);
    for (std::size_t i = 0; i < pairs; ++i)
      keep[sorted[first + i].face] = keep[sorted[last - 1 - i].face] = 0;
  }
}

void keep_faces(Assembly& assembly, const std::vector<Index>& rows) {
  Mesh& mesh = assembly.mesh;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    mesh.faces[i] = mesh.faces[rows[i]];
    assembly.source_face[i] = assembly.source_face[rows[i]];
    assembly.face_is_new[i] = assembly.face_is_new[rows[i]];
  }
  mesh.faces.resize(rows.size());
  assembly.source_face.resize(rows.size());
  assembly.face_is_new.resize(rows.size());
  mesh.face_columns = mesh.face_columns.select(rows);
}

}  // namespace

// Searches only new faces and the faces whose boxes overlap with theirs. Other faces cannot
// intersect a new face.
BrokenFaces find_broken_faces(const Assembly& assembly, const DisjointFaces& known) {
  const std::vector<Index> rows = marked(find_faces_at_new_ones(assembly));
  const Mesh part = mesh_of_faces(assembly.mesh, rows);
  std::vector<char> is_broken(assembly.mesh.faces.size(), 0);
  BrokenFaces result;
  for (const Index f : degenerate_faces(part)) is_broken[rows[f]] = 1;
  std::vector<char> is_disjoint(rows.size(), 1);
  for (const auto& [f, g] : find_intersections(part, known, Progress())) {
    is_disjoint[f] = is_disjoint[g] = 0;
    if (!assembly.face_is_new[rows[f]] && !assembly.face_is_new[rows[g]]) continue;
    result.pairs.emplace_back(rows[f], rows[g]);
    is_broken[rows[f]] = is_broken[rows[g]] = 1;
  }
  result.faces = marked(is_broken);
  for (const Index f : marked(is_disjoint)) result.disjoint.push_back(rows[f]);
  return result;
}

std::vector<Index> with_faces_around(const Mesh& mesh, const std::vector<Index>& faces) {
  std::vector<char> is_corner(mesh.positions.size(), 0);
  for (const Index face : faces)
    for (const Index v : mesh.faces[face]) is_corner[v] = 1;
  std::vector<Index> result;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    if (is_corner[a] || is_corner[b] || is_corner[c]) result.push_back(f);
  }
  return result;
}

std::size_t count_places(const Mesh& mesh, const std::vector<Index>& faces) {
  DisjointSets sets(mesh.positions.size());
  std::vector<char> is_corner(mesh.positions.size(), 0);
  std::size_t places = 0;
  for (const Index face : faces) {
    const auto& [a, b, c] = mesh.faces[face];
    for (const Index v : {a, b, c}) {
      places += is_corner[v] ? 0 : 1;
      is_corner[v] = 1;
    }
    places -= (sets.join(a, b) ? 1 : 0) + (sets.join(a, c) ? 1 : 0);
  }
  return places;
}

bool drop_collapsed_faces(Assembly& assembly) {
  Mesh& mesh = assembly.mesh;
  const std::vector<Index> first = find_first_vertices(mesh.positions);
  std::vector<char> keep(mesh.faces.size(), 1);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    for (Index& v : mesh.faces[f]) v = first[v];
    keep[f] = is_collapsed(mesh.faces[f]) ? 0 : 1;
  }
  cancel_opposite_faces(assembly, keep);
  const std::vector<Index> rows = marked(keep);
  if (rows.size() == keep.size()) return false;
  keep_faces(assembly, rows);
  return true;
}

}  // namespace transformesh
