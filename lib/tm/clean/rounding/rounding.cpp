#include "tm/clean/rounding/rounding.h"

#include <algorithm>
#include <cmath>

#include "tm/clean/intersect/contacts.h"
#include "tm/clean/intersect/soup.h"
#include "tm/clean/rounding/crowds.h"
#include "tm/clean/rounding/unite_close.h"
#include "tm/clean/stitch/weld.h"
#include "tm/geometry/bvh.h"
#include "tm/geometry/predicates.h"
#include "tm/support/single.h"

namespace transformesh {
namespace {

// The new faces of the soup, and a hierarchy over them.
struct NewFaces {
  std::vector<Index> faces;
  Bvh bvh;
};

NewFaces collect_new_faces(const Assembly& assembly, const Soup& soup) {
  NewFaces result;
  std::vector<FloatBox> boxes;
  for (Index f = 0; f < soup.faces.size(); ++f) {
    if (!assembly.face_is_new[soup.face_of[f]]) continue;
    result.faces.push_back(f);
    boxes.push_back(soup.box(f));
  }
  result.bvh = Bvh(boxes);
  return result;
}

void mark_faces_without_area(const Mesh& mesh, const Soup& soup, std::vector<char>& broken) {
  std::vector<char> has_area(mesh.faces.size(), 0);
  for (const Index f : soup.face_of) has_area[f] = 1;
  for (std::size_t f = 0; f < has_area.size(); ++f) broken[f] |= has_area[f] == 0;
}

void mark_crossings(const Assembly& assembly, const Soup& soup, const NewFaces& news,
                    std::vector<char>& broken) {
  const auto mark = [&](Index f, Index g) {
    broken[soup.face_of[f]] = broken[soup.face_of[g]] = 1;
  };
  const auto meet = [&](Index i, Index k) {
    return find_contacts(soup, news.faces[i], news.faces[k]).meet;
  };
  for (const auto& [i, k] : news.bvh.overlapping_pairs(meet)) mark(news.faces[i], news.faces[k]);
  for (Index f = 0; f < soup.faces.size(); ++f) {
    if (assembly.face_is_new[soup.face_of[f]]) continue;
    news.bvh.visit_overlaps(soup.box(f), [&](Index i) {
      if (find_contacts(soup, f, news.faces[i]).meet) mark(f, news.faces[i]);
      return true;
    });
  }
}

bool is_before(const Vec3& a, const Vec3& b) { return compare_positions(a, b) < 0; }

// The distinct positions of corners, those of input vertices first. What is at one position moves
// together, whatever faces it is of: else the surface would tear.
class Places {
 public:
  Places(const Assembly& assembly, const std::vector<Index>& faces);
  const std::vector<Vec3>& positions() const { return positions_; }
  std::size_t inputs() const { return inputs_; }
  void move(Mesh& mesh, const std::vector<Vec3>& to) const;

 private:
  Index find(const Vec3& position) const;

  std::vector<Vec3> positions_;
  std::vector<Vec3> sorted_;
  std::vector<Index> place_of_;  ///< of those in sorted_
  std::size_t inputs_ = 0;
};

Places::Places(const Assembly& assembly, const std::vector<Index>& faces) {
  const Mesh& mesh = assembly.mesh;
  for (const Index face : faces)
    for (const Index v : mesh.faces[face]) sorted_.push_back(mesh.positions[v]);
  std::sort(sorted_.begin(), sorted_.end(), is_before);
  sorted_.erase(std::unique(sorted_.begin(), sorted_.end()), sorted_.end());

  place_of_.assign(sorted_.size(), no_index);
  for (const bool is_new : {false, true}) {
    for (Index v = 0; v < mesh.positions.size(); ++v) {
      if ((assembly.vertex_is_new[v] != 0) != is_new) continue;
      const Index found = find(mesh.positions[v]);
      if (found == no_index || place_of_[found] != no_index) continue;
      place_of_[found] = static_cast<Index>(positions_.size());
      positions_.push_back(mesh.positions[v]);
    }
    if (!is_new) inputs_ = positions_.size();
  }
}

Index Places::find(const Vec3& position) const {
  const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), position, is_before);
  if (found == sorted_.end() || *found != position) return no_index;
  return static_cast<Index>(found - sorted_.begin());
}

void Places::move(Mesh& mesh, const std::vector<Vec3>& to) const {
  for (Vec3& position : mesh.positions) {
    const Index found = find(position);
    if (found != no_index) position = to[place_of_[found]];
  }
}

Index nearest(const std::vector<Vec3>& positions, const std::vector<Index>& among,
              const Vec3& point) {
  return *std::min_element(among.begin(), among.end(), [&](Index a, Index b) {
    return (positions[a] - point).stableNorm() < (positions[b] - point).stableNorm();
  });
}

// Where those of a crowd go: the first positions stay.
void unite_crowd(const std::vector<Index>& crowd, std::size_t inputs,
                 const std::vector<Vec3>& positions, std::vector<Vec3>& moved) {
  const auto first_new = std::lower_bound(crowd.begin(), crowd.end(), inputs);
  std::vector<Index> fixed(crowd.begin(), first_new);
  if (fixed.empty()) fixed = {nearest(positions, crowd, box_around(positions, crowd).center())};
  std::for_each(first_new, crowd.end(),
                [&](Index i) { moved[i] = positions[nearest(positions, fixed, positions[i])]; });
}

double largest_coordinate(const Mesh& mesh) {
  double largest = 0;
  for (const Vec3& p : mesh.positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

}  // namespace

std::vector<Index> find_broken_faces(const Assembly& assembly) {
  const Soup soup = make_soup(assembly.mesh);
  std::vector<char> broken(assembly.mesh.faces.size(), 0);
  mark_faces_without_area(assembly.mesh, soup, broken);
  const NewFaces news = collect_new_faces(assembly, soup);
  if (!news.faces.empty()) mark_crossings(assembly, soup, news, broken);
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

double merge_distance(const Mesh& mesh, Scalar coordinate, int doublings) {
  const int digits = coordinate == Scalar::float32 ? 24 : 53;
  return std::ldexp(1.0, std::ilogb(largest_coordinate(mesh)) + 1 - digits + doublings);
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
  const Places places(assembly, faces);
  std::vector<Vec3> moved;
  for (const Index i : gather(places.positions(), places.inputs(), distance))
    moved.push_back(places.positions()[i]);
  places.move(assembly.mesh, moved);
}

void merge_crowds(Assembly& assembly, const std::vector<Index>& faces, Scalar coordinate) {
  const double spacing = merge_distance(assembly.mesh, coordinate, 0);
  const Places places(assembly, with_near_faces(assembly.mesh, faces, widest_crowd * spacing));
  std::vector<Vec3> moved = places.positions();
  for (const std::vector<Index>& crowd : find_crowds(places.positions(), spacing))
    unite_crowd(crowd, places.inputs(), places.positions(), moved);
  places.move(assembly.mesh, moved);
}

Mesh snap_to_grid(const Mesh& mesh, const std::vector<char>& marked_faces, double spacing,
                  Scalar coordinate) {
  const Soup soup = make_soup(mesh);
  std::vector<char> is_marked(soup.points.size(), 0);
  for (std::size_t f = 0; f < marked_faces.size(); ++f) {
    if (!marked_faces[f]) continue;
    for (const Index v : mesh.faces[f]) is_marked[soup.point_of[v]] = 1;
  }
  std::vector<Vec3> points;
  for (std::size_t p = 0; p < is_marked.size(); ++p) {
    if (is_marked[p]) points.push_back(soup.points[p]);
  }
  const std::vector<Index> representative = weld(points, spacing / 8);

  Mesh snapped = mesh;
  std::vector<Vec3> moved = soup.points;
  for (std::size_t p = 0, i = 0; p < is_marked.size(); ++p) {
    if (!is_marked[p]) continue;
    moved[p] = points[representative[i++]];
    for (double& x : moved[p]) x = std::round(x / spacing) * spacing;
  }
  for (std::size_t v = 0; v < soup.point_of.size(); ++v) {
    if (!is_marked[soup.point_of[v]]) continue;
    snapped.positions[v] = moved[soup.point_of[v]];
    if (coordinate != Scalar::float32) continue;
    for (double& x : snapped.positions[v]) x = round_to_single(x);
  }
  return snapped;
}

}  // namespace transformesh
