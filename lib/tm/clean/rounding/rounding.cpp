#include "tm/clean/rounding/rounding.h"

#include <algorithm>
#include <cmath>

#include "tm/clean/intersect/contacts.h"
#include "tm/clean/intersect/welded_mesh.h"
#include "tm/clean/rounding/clusters.h"
#include "tm/clean/rounding/unite_close.h"
#include "tm/clean/stitch/weld.h"
#include "tm/geometry/bvh.h"
#include "tm/geometry/predicates.h"
#include "tm/mesh/digits.h"

namespace transformesh {
namespace {

// The new faces of a welded mesh, and a hierarchy over them.
struct NewFaces {
  std::vector<Index> faces;
  Bvh bvh;
};

NewFaces collect_new_faces(const Assembly& assembly, const WeldedMesh& welded) {
  NewFaces result;
  std::vector<FloatBox> boxes;
  for (Index f = 0; f < welded.faces.size(); ++f) {
    if (!assembly.face_is_new[welded.face_of[f]]) continue;
    result.faces.push_back(f);
    boxes.push_back(welded.box(f));
  }
  result.bvh = Bvh(boxes);
  return result;
}

void mark_faces_without_area(const Mesh& mesh, const WeldedMesh& welded,
                             std::vector<char>& broken) {
  std::vector<char> has_area(mesh.faces.size(), 0);
  for (const Index f : welded.face_of) has_area[f] = 1;
  for (std::size_t f = 0; f < has_area.size(); ++f) broken[f] |= has_area[f] == 0;
}

void mark_crossings(const Assembly& assembly, const WeldedMesh& welded, const NewFaces& news,
                    std::vector<char>& broken) {
  const auto mark = [&](Index f, Index g) {
    broken[welded.face_of[f]] = broken[welded.face_of[g]] = 1;
  };
  const auto meet = [&](Index i, Index k) {
    return find_contacts(welded, news.faces[i], news.faces[k]).meet;
  };
  for (const auto& [i, k] : news.bvh.overlapping_pairs(meet)) mark(news.faces[i], news.faces[k]);
  for (Index f = 0; f < welded.faces.size(); ++f) {
    if (assembly.face_is_new[welded.face_of[f]]) continue;
    news.bvh.visit_overlaps(welded.box(f), [&](Index i) {
      if (find_contacts(welded, f, news.faces[i]).meet) mark(f, news.faces[i]);
      return true;
    });
  }
}

bool is_before(const Vec3& a, const Vec3& b) { return compare_positions(a, b) < 0; }

// The distinct positions of the corners of some faces, those of input vertices first. All vertices
// at one position move together, even those of other faces: else the surface would tear.
class DistinctPositions {
 public:
  DistinctPositions(const Assembly& assembly, const std::vector<Index>& faces);
  const std::vector<Vec3>& positions() const { return positions_; }
  std::size_t inputs() const { return inputs_; }
  void move(Mesh& mesh, const std::vector<Vec3>& to) const;

 private:
  Index find(const Vec3& position) const;

  std::vector<Vec3> positions_;
  std::vector<Vec3> sorted_;
  std::vector<Index> number_of_;  ///< of the sorted positions among positions_
  std::size_t inputs_ = 0;        ///< how many are of input vertices
};

DistinctPositions::DistinctPositions(const Assembly& assembly, const std::vector<Index>& faces) {
  const Mesh& mesh = assembly.mesh;
  for (const Index face : faces)
    for (const Index v : mesh.faces[face]) sorted_.push_back(mesh.positions[v]);
  std::sort(sorted_.begin(), sorted_.end(), is_before);
  sorted_.erase(std::unique(sorted_.begin(), sorted_.end()), sorted_.end());

  number_of_.assign(sorted_.size(), no_index);
  for (const bool is_new : {false, true}) {
    for (Index v = 0; v < mesh.positions.size(); ++v) {
      if ((assembly.vertex_is_new[v] != 0) != is_new) continue;
      const Index found = find(mesh.positions[v]);
      if (found == no_index || number_of_[found] != no_index) continue;
      number_of_[found] = static_cast<Index>(positions_.size());
      positions_.push_back(mesh.positions[v]);
    }
    if (!is_new) inputs_ = positions_.size();
  }
}

Index DistinctPositions::find(const Vec3& position) const {
  const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), position, is_before);
  if (found == sorted_.end() || *found != position) return no_index;
  return static_cast<Index>(found - sorted_.begin());
}

void DistinctPositions::move(Mesh& mesh, const std::vector<Vec3>& to) const {
  for (Vec3& position : mesh.positions) {
    const Index found = find(position);
    if (found != no_index) position = to[number_of_[found]];
  }
}

Index nearest(const std::vector<Vec3>& positions, const std::vector<Index>& among,
              const Vec3& point) {
  return *std::min_element(among.begin(), among.end(), [&](Index a, Index b) {
    return (positions[a] - point).stableNorm() < (positions[b] - point).stableNorm();
  });
}

// Moves the positions of a cluster to one of them, or to those of input vertices, which come first.
void merge_cluster(const std::vector<Index>& cluster, std::size_t inputs,
                   const std::vector<Vec3>& positions, std::vector<Vec3>& moved) {
  const auto first_new = std::lower_bound(cluster.begin(), cluster.end(), inputs);
  std::vector<Index> fixed(cluster.begin(), first_new);
  if (fixed.empty())
    fixed = {nearest(positions, cluster, box_of_group(positions, cluster).center())};
  std::for_each(first_new, cluster.end(),
                [&](Index i) { moved[i] = positions[nearest(positions, fixed, positions[i])]; });
}

}  // namespace

std::vector<Index> find_broken_faces(const Assembly& assembly) {
  const WeldedMesh welded = weld(assembly.mesh);
  std::vector<char> broken(assembly.mesh.faces.size(), 0);
  mark_faces_without_area(assembly.mesh, welded, broken);
  const NewFaces news = collect_new_faces(assembly, welded);
  if (!news.faces.empty()) mark_crossings(assembly, welded, news, broken);
  std::vector<Index> result;
  for (Index f = 0; f < broken.size(); ++f) {
    if (broken[f]) result.push_back(f);
  }
  return result;
}

std::vector<Index> find_new_faces(const Assembly& assembly) {
  std::vector<Index> result;
  for (Index f = 0; f < assembly.face_is_new.size(); ++f) {
    if (assembly.face_is_new[f]) result.push_back(f);
  }
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

void merge_close_vertices(Assembly& assembly, const std::vector<Index>& faces, double distance) {
  const DistinctPositions distinct(assembly, faces);
  std::vector<Vec3> moved;
  for (const Index i : snap_positions(distinct.positions(), distinct.inputs(), distance))
    moved.push_back(distinct.positions()[i]);
  distinct.move(assembly.mesh, moved);
}

void merge_clusters(Assembly& assembly, const std::vector<Index>& faces, Scalar coordinate) {
  const double spacing = coordinate_spacing(assembly.mesh, coordinate);
  const DistinctPositions distinct(assembly,
                                   with_near_faces(assembly.mesh, faces, widest_cluster * spacing));
  std::vector<Vec3> moved = distinct.positions();
  for (const std::vector<Index>& cluster : find_clusters(distinct.positions(), spacing))
    merge_cluster(cluster, distinct.inputs(), distinct.positions(), moved);
  distinct.move(assembly.mesh, moved);
}

Mesh snap_to_grid(const Mesh& mesh, const std::vector<char>& marked_faces, double spacing,
                  Scalar coordinate) {
  const WeldedMesh welded = weld(mesh);
  std::vector<char> is_marked(welded.points.size(), 0);
  for (std::size_t f = 0; f < marked_faces.size(); ++f) {
    if (!marked_faces[f]) continue;
    for (const Index v : mesh.faces[f]) is_marked[welded.point_of[v]] = 1;
  }
  std::vector<Vec3> points;
  for (std::size_t p = 0; p < is_marked.size(); ++p) {
    if (is_marked[p]) points.push_back(welded.points[p]);
  }
  const std::vector<Index> representative = weld_positions(points, spacing / 8);

  Mesh snapped = mesh;
  std::vector<Vec3> moved = welded.points;
  for (std::size_t p = 0, i = 0; p < is_marked.size(); ++p) {
    if (!is_marked[p]) continue;
    moved[p] = points[representative[i++]];
    for (double& x : moved[p]) x = std::round(x / spacing) * spacing;
  }
  for (std::size_t v = 0; v < welded.point_of.size(); ++v) {
    if (!is_marked[welded.point_of[v]]) continue;
    snapped.positions[v] = moved[welded.point_of[v]];
    if (coordinate != Scalar::float32) continue;
    for (double& x : snapped.positions[v]) x = round_to_single(x);
  }
  return snapped;
}

}  // namespace transformesh
