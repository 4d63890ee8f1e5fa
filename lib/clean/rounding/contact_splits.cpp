#include "clean/rounding/contact_splits.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "clean/arrange/refine.h"
#include "clean/rounding/broken_faces.h"
#include "clean/rounding/local_distance.h"

namespace transformesh {
namespace {

class ContactSplitter {
 public:
  ContactSplitter(Assembly& assembly, double spacings, const Spacings& spacing);
  Displacement split(const std::vector<FacePair>& intersections);

 private:
  using Ends = std::array<Index, 2>;

  const Vec3& at(Index vertex) const { return mesh_.positions[vertex]; }
  Ends edge(Index face, std::size_t i) const {
    return {mesh_.faces[face][i], mesh_.faces[face][(i + 1) % 3]};
  }
  double reach(const Vec3& position, const Vec3& direction) const {
    return spacings_ * spacing_.along(direction, position);
  }
  bool split_at_corners(Index face, Index other);
  bool split_at_corner(Index face, Index vertex);
  std::optional<Ends> edge_beside(Index face, Index vertex) const;
  bool is_over(Index face, const Vec3& point) const;
  bool split_edges(const Ends& first, const Ends& second);
  std::optional<Vec3> point_between(Ends first, Ends second);
  Index find_free_face(const Ends& ends) const;
  Index add_vertex(const Vec3& position, Index face);
  bool split_edge(const Ends& ends, Index vertex);
  void split_side(Index face, const Ends& ends, Index vertex);
  void split_face(Index face, Index vertex);
  void replace(Index face, const Face& corners);
  void append(const Face& corners, Index source);

  Assembly& assembly_;
  Mesh& mesh_;
  double spacings_;
  const Spacings& spacing_;
  std::map<Ends, Index> face_at_;  ///< per halfedge of faces that are not split yet
  std::vector<char> is_split_;
  std::vector<Index> rows_;  ///< per face: that which it was cut from
  Displacement displacement_;
};

ContactSplitter::ContactSplitter(Assembly& assembly, double spacings, const Spacings& spacing)
    : assembly_(assembly),
      mesh_(assembly.mesh),
      spacings_(spacings),
      spacing_(spacing),
      is_split_(assembly.mesh.faces.size(), 0) {}

// The face with that halfedge, if it is not split yet.
Index ContactSplitter::find_free_face(const Ends& ends) const {
  const auto found = face_at_.find(ends);
  return found == face_at_.end() || is_split_[found->second] ? no_index : found->second;
}

void ContactSplitter::replace(Index face, const Face& corners) {
  mesh_.faces[face] = corners;
  is_split_[face] = assembly_.face_is_new[face] = 1;
}

void ContactSplitter::append(const Face& corners, Index source) {
  mesh_.faces.push_back(corners);
  rows_.push_back(source);
  assembly_.source_face.push_back(assembly_.source_face[source]);
  assembly_.face_is_new.push_back(1);
  is_split_.push_back(1);
}

void ContactSplitter::split_face(Index face, Index vertex) {
  const auto [a, b, c] = mesh_.faces[face];
  replace(face, {a, b, vertex});
  append({b, c, vertex}, face);
  append({c, a, vertex}, face);
}

void ContactSplitter::split_side(Index face, const Ends& ends, Index vertex) {
  Index apex = no_index;
  for (const Index v : mesh_.faces[face])
    if (v != ends[0] && v != ends[1]) apex = v;
  replace(face, {ends[0], vertex, apex});
  append({vertex, ends[1], apex}, face);
}

bool ContactSplitter::split_edge(const Ends& ends, Index vertex) {
  const Ends back = {ends[1], ends[0]};
  const Index left = find_free_face(ends), right = find_free_face(back);
  if (left == no_index || right == no_index || left == right) return false;
  split_side(left, ends, vertex);
  split_side(right, back, vertex);
  return true;
}

// The edge of the face to which the vertex is closest, if it is within reach of its interior.
std::optional<ContactSplitter::Ends> ContactSplitter::edge_beside(Index face, Index vertex) const {
  std::optional<Ends> best;
  double least = 1;  // in shares of the reach
  for (std::size_t i = 0; i < 3; ++i) {
    const Ends ends = edge(face, i);
    const LineDistance from_edge = distance_from_line(at(ends[0]), at(ends[1]), at(vertex));
    const double share =
        from_edge.distance > 0 ? from_edge.distance / reach(at(vertex), from_edge.across) : 0;
    if (from_edge.beyond >= 0 || share > least) continue;
    least = share;
    best = ends;
  }
  return best;
}

// Whether the point is within reach of the interior of the face.
bool ContactSplitter::is_over(Index face, const Vec3& point) const {
  const Triangle t = triangle_of(mesh_, face);
  const Vec3 normal = unit_normal(t);
  if (normal.isZero(0) || std::abs(height_over(t, normal, point)) > reach(point, normal))
    return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 side = (t[(i + 1) % 3] - t[i]).stableNormalized();
    if (!(side.cross(point - t[i]).dot(normal) > 0)) return false;
  }
  return true;
}

bool ContactSplitter::split_at_corner(Index face, Index vertex) {
  for (const Index v : mesh_.faces[face])
    if (v == vertex) return false;
  const std::optional<Ends> beside = edge_beside(face, vertex);
  if (beside) return split_edge(*beside, vertex);
  if (!is_over(face, at(vertex))) return false;
  split_face(face, vertex);
  return true;
}

bool ContactSplitter::split_at_corners(Index face, Index other) {
  const Face corners = mesh_.faces[other];
  return std::any_of(corners.begin(), corners.end(),
                     [&](Index vertex) { return split_at_corner(face, vertex); });
}

// The point in the middle between two edges where they pass each other within reach. They are
// followed from the ends that have the smaller coordinates, which locate it best.
std::optional<Vec3> ContactSplitter::point_between(Ends first, Ends second) {
  const auto is_smaller = [&](Index a, Index b) {
    return at(a).cwiseAbs().maxCoeff() < at(b).cwiseAbs().maxCoeff();
  };
  if (is_smaller(first[1], first[0])) std::swap(first[0], first[1]);
  if (is_smaller(second[1], second[0])) std::swap(second[0], second[1]);
  const Vec3 u = at(first[1]) - at(first[0]), v = at(second[1]) - at(second[0]);
  const Vec3 w = at(first[0]) - at(second[0]);
  const double determinant = u.squaredNorm() * v.squaredNorm() - u.dot(v) * u.dot(v);
  const double s = (u.dot(v) * v.dot(w) - v.squaredNorm() * u.dot(w)) / determinant;
  const double t = (u.squaredNorm() * v.dot(w) - u.dot(v) * u.dot(w)) / determinant;
  if (!(determinant > 0 && s > 0 && s < 1 && t > 0 && t < 1)) return std::nullopt;
  const Vec3 p = at(first[0]) + s * u, q = at(second[0]) + t * v;
  const Vec3 middle = rounded_to(p + (q - p) / 2, spacing_.type);
  const auto is_end = [&](Index end) { return at(end) == middle; };
  const Vec3 gap = q - p;
  if (gap.stableNorm() > reach(middle, gap.stableNormalized()) ||
      std::any_of(first.begin(), first.end(), is_end) ||
      std::any_of(second.begin(), second.end(), is_end))
    return std::nullopt;
  return middle;
}

Index ContactSplitter::add_vertex(const Vec3& position, Index face) {
  mesh_.vertex_columns.append(row_on_face(mesh_, face, position));
  mesh_.positions.push_back(position);
  assembly_.vertex_is_new.push_back(1);
  assembly_.input_vertex.push_back(no_index);
  return static_cast<Index>(mesh_.positions.size() - 1);
}

bool ContactSplitter::split_edges(const Ends& first, const Ends& second) {
  for (const Index end : first)
    if (end == second[0] || end == second[1]) return false;
  std::array<Index, 4> faces = {find_free_face(first), find_free_face({first[1], first[0]}),
                                find_free_face(second), find_free_face({second[1], second[0]})};
  const Index face = faces[0];
  std::sort(faces.begin(), faces.end());
  if (faces[3] == no_index || std::adjacent_find(faces.begin(), faces.end()) != faces.end())
    return false;
  const std::optional<Vec3> middle = point_between(first, second);
  if (!middle) return false;
  const Index vertex = add_vertex(*middle, face);
  return split_edge(first, vertex) && split_edge(second, vertex);
}

Displacement ContactSplitter::split(const std::vector<FacePair>& intersections) {
  std::vector<Index> crossed;
  for (const auto& [face, other] : intersections) crossed.insert(crossed.end(), {face, other});
  for (const Index face : with_faces_around(mesh_, crossed))
    for (std::size_t i = 0; i < 3; ++i) face_at_[edge(face, i)] = face;

  for (const auto& [face, other] : intersections) {
    if (is_split_[face] || is_split_[other]) continue;
    bool is_done = split_at_corners(other, face) || split_at_corners(face, other);
    for (std::size_t i = 0; i < 9 && !is_done; ++i)
      is_done = split_edges(edge(face, i / 3), edge(other, i % 3));
    const double spacing = spacing_around(at(mesh_.faces[face][0]), spacing_.type);
    if (is_done) displacement_.note(spacings_ * spacing, spacing);
  }
  std::vector<Index> rows;
  for (Index face = 0; face + rows_.size() < mesh_.faces.size(); ++face) rows.push_back(face);
  rows.insert(rows.end(), rows_.begin(), rows_.end());
  mesh_.face_columns = mesh_.face_columns.select(rows);
  return displacement_;
}

}  // namespace

Displacement split_at_contacts(Assembly& assembly, const std::vector<FacePair>& intersections,
                               double spacings, const Spacings& spacing) {
  return ContactSplitter(assembly, spacings, spacing).split(intersections);
}

}  // namespace transformesh
