#include "tm/clean/unite_close.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tm/clean/face_row.h"
#include "tm/clean/face_splitter.h"
#include "tm/clean/soup.h"
#include "tm/geometry/bvh.h"
#include "tm/support/single.h"

namespace transformesh {
namespace {

// Of close faces, for each of them. Where more pass one place, uniting each with each makes more
// slivers than it mends.
constexpr std::size_t most_pairs = 30;

// An edge as its points, the smaller one first.
using PointPair = std::array<Index, 2>;

// A point that splits an edge, and at which share of it.
using Cut = std::pair<double, Index>;

PointPair edge_of(const Face& face, std::size_t i) {
  const Index a = face[i], b = face[(i + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

bool is_within(const WidePoint& step, const Vec3& reach) {
  return (step.cwiseAbs().array() <= wide(reach).array()).all();
}

// Whether the point is that close to the inside of the triangle.
bool is_over(const Triangle& t, const Vec3& point, const Vec3& reach) {
  const WidePoint a = wide(t[0]), p = wide(point);
  const WidePoint normal = (wide(t[1]) - a).cross(wide(t[2]) - a).stableNormalized();
  if (!is_within((p - a).dot(normal) * normal, reach)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const WidePoint from = wide(t[i]), to = wide(t[(i + 1) % 3]);
    if (!((to - from).cross(p - from).dot(normal) > 0)) return false;
  }
  return true;
}

// Where two segments come closest, as shares of their lengths; not inside them if parallel.
std::array<long double, 2> closest_shares(const Vec3& a, const Vec3& b, const Vec3& c,
                                          const Vec3& d) {
  const WidePoint u = wide(b) - wide(a), v = wide(d) - wide(c), w = wide(a) - wide(c);
  const long double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), uw = u.dot(w), vw = v.dot(w);
  const long double determinant = uu * vv - uv * uv;
  if (!(determinant > 0)) return {0, 0};
  return {(uv * vw - vv * uw) / determinant, (uu * vw - uv * uw) / determinant};
}

FloatBox box_around(const Soup& soup, const Triangle& t, double distance) {
  const Vec3 reach = Vec3::Constant(distance);
  return soup.frame.box(t[0].cwiseMin(t[1]).cwiseMin(t[2]) - reach,
                        t[0].cwiseMax(t[1]).cwiseMax(t[2]) + reach);
}

class Uniter {
 public:
  Uniter(Assembly& assembly, const Closeness& closeness, Scalar coordinate);
  bool unite(const std::vector<Index>& faces);

 private:
  Vec3 reach_at(std::initializer_list<Index> points) const;
  Vec3 reach_of(const Vec3& size) const;
  std::vector<Bvh::Pair> close_pairs(const std::vector<Index>& faces) const;
  bool is_beside(const PointPair& edge, Index point, double& share) const;
  bool touches_end(const PointPair& first, const PointPair& second) const;
  void unite_corner(Index point, Index face);
  void unite_edges(const PointPair& first, const PointPair& second);
  Index point_between(const PointPair& first, const PointPair& second, const Vec3& position);
  std::vector<Cut> cuts_of(const PointPair& edge) const;
  std::vector<Index> chain_of(const PointPair& edge) const;
  std::set<Index> points_on(Index face) const;
  void constrain(Index face, Index other);
  bool is_split(Index face) const;
  std::vector<Face> split(Index face) const;
  void split_faces();
  void add_vertices(const std::vector<Face>& pieces, const std::vector<Index>& rows);
  Triangle triangle(Index face) const {
    const Face& f = corners_[face];
    return {points_[f[0]], points_[f[1]], points_[f[2]]};
  }

  Assembly& assembly_;
  const Soup soup_;
  const Closeness closeness_;
  const double distance_;
  const Scalar coordinate_;
  int largest_ = 0;                                       ///< exponent of the largest coordinate
  std::vector<Face> corners_;                             ///< of all faces, as points
  std::vector<Vec3> points_;                              ///< of the soup, then new ones
  std::map<PointPair, std::map<Index, double>> on_edge_;  ///< points, and at which share
  std::map<Index, std::set<Index>> inside_;               ///< points, per face
  std::map<Index, std::set<PointPair>> constraints_;      ///< per face
  std::map<std::array<PointPair, 2>, Index> between_;     ///< new points
};

Uniter::Uniter(Assembly& assembly, const Closeness& closeness, Scalar coordinate)
    : assembly_(assembly),
      soup_(make_soup(assembly.mesh)),
      closeness_(closeness),
      distance_(closeness.distance),
      coordinate_(coordinate),
      points_(soup_.points) {
  double largest = 0;
  for (const Vec3& p : points_) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  largest_ = std::ilogb(largest);
  for (const Face& f : assembly.mesh.faces)
    corners_.push_back({soup_.point_of[f[0]], soup_.point_of[f[1]], soup_.point_of[f[2]]});
}

std::vector<Bvh::Pair> Uniter::close_pairs(const std::vector<Index>& faces) const {
  std::vector<FloatBox> boxes;
  for (const Index f : faces) boxes.push_back(box_around(soup_, triangle(f), distance_));
  return Bvh(boxes).overlapping_pairs([](Index, Index) { return true; });
}

// Along each axis, for parts whose coordinates are of that size: numbers near zero are closer.
Vec3 Uniter::reach_of(const Vec3& size) const {
  if (!closeness_.is_local) return Vec3::Constant(distance_);
  return size.unaryExpr([&](double x) {
    const int exponent = x > 0 ? std::max(std::ilogb(x) - largest_, -20) : -20;
    return std::ldexp(distance_, exponent);
  });
}

Vec3 Uniter::reach_at(std::initializer_list<Index> points) const {
  Vec3 size = Vec3::Zero();
  for (const Index p : points) size = size.cwiseMax(points_[p].cwiseAbs());
  return reach_of(size);
}

// Whether the point is close to the inside of the edge, and where.
bool Uniter::is_beside(const PointPair& edge, Index point, double& share) const {
  if (point == edge[0] || point == edge[1]) return false;
  const WidePoint from = wide(points_[edge[0]]);
  const WidePoint along = wide(points_[edge[1]]) - from, to = wide(points_[point]) - from;
  const long double at = to.dot(along) / along.dot(along);
  share = static_cast<double>(at);
  return at > 0 && at < 1 && is_within(to - at * along, reach_at({edge[0], edge[1], point}));
}

void Uniter::unite_corner(Index point, Index face) {
  const Face& corners = corners_[face];
  bool is_on_edge = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const PointPair edge = edge_of(corners, i);
    double share = 0;
    if (!is_beside(edge, point, share)) continue;
    on_edge_[edge].emplace(point, share);
    is_on_edge = true;
  }
  if (is_on_edge || std::count(corners.begin(), corners.end(), point) > 0) return;
  const Vec3 reach = reach_at({corners[0], corners[1], corners[2], point});
  if (is_over(triangle(face), points_[point], reach)) inside_[face].insert(point);
}

// Then it is up to that end.
bool Uniter::touches_end(const PointPair& first, const PointPair& second) const {
  double share = 0;
  const auto is_near = [&](const PointPair& edge, Index point) {
    return point == edge[0] || point == edge[1] || is_beside(edge, point, share);
  };
  return is_near(first, second[0]) || is_near(first, second[1]) || is_near(second, first[0]) ||
         is_near(second, first[1]);
}

void Uniter::unite_edges(const PointPair& first, const PointPair& second) {
  if (touches_end(first, second)) return;
  const Vec3 &a = points_[first[0]], &b = points_[first[1]];
  const Vec3 &c = points_[second[0]], &d = points_[second[1]];
  const auto [s, t] = closest_shares(a, b, c, d);
  if (!(s > 0 && s < 1 && t > 0 && t < 1)) return;
  const WidePoint p = wide(a) + s * (wide(b) - wide(a)), q = wide(c) + t * (wide(d) - wide(c));
  const Vec3 reach = reach_at({first[0], first[1], second[0], second[1]});
  const auto is_near = [&](const WidePoint& x, const WidePoint& y) {
    return is_within(x - y, reach);
  };
  if (!is_near(p, q) || is_near(p, wide(a)) || is_near(p, wide(b)) || is_near(q, wide(c)) ||
      is_near(q, wide(d)))
    return;
  const Index point = point_between(first, second, ((p + q) / 2).cast<double>());
  on_edge_[first].emplace(point, static_cast<double>(s));
  on_edge_[second].emplace(point, static_cast<double>(t));
}

Index Uniter::point_between(const PointPair& first, const PointPair& second, const Vec3& position) {
  const auto [entry, is_new] = between_.try_emplace(
      {std::min(first, second), std::max(first, second)}, static_cast<Index>(points_.size()));
  if (!is_new) return entry->second;
  points_.push_back(position);
  if (coordinate_ == Scalar::float32)
    for (double& x : points_.back()) x = round_to_single(x);
  return entry->second;
}

// In their order along the edge, which all its faces must share.
std::vector<Cut> Uniter::cuts_of(const PointPair& edge) const {
  std::vector<Cut> cuts;
  const auto found = on_edge_.find(edge);
  if (found == on_edge_.end()) return cuts;
  for (const auto& [point, share] : found->second) cuts.emplace_back(share, point);
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

std::vector<Index> Uniter::chain_of(const PointPair& edge) const {
  std::vector<Index> chain = {edge[0]};
  for (const Cut& cut : cuts_of(edge)) chain.push_back(cut.second);
  chain.push_back(edge[1]);
  return chain;
}

std::set<Index> Uniter::points_on(Index face) const {
  std::set<Index> points;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<Index> chain = chain_of(edge_of(corners_[face], i));
    points.insert(chain.begin(), chain.end());
  }
  const auto found = inside_.find(face);
  if (found != inside_.end()) points.insert(found->second.begin(), found->second.end());
  return points;
}

// Edges of the other face whose ends are on the face become edges there.
void Uniter::constrain(Index face, Index other) {
  const std::set<Index> points = points_on(face);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<Index> chain = chain_of(edge_of(corners_[other], i));
    for (std::size_t k = 0; k + 1 < chain.size(); ++k)
      if (points.contains(chain[k]) && points.contains(chain[k + 1]))
        constraints_[face].insert({chain[k], chain[k + 1]});
  }
}

// Faces without area too, as their edges are those of others. Of those that name a point twice the
// edges cancel out.
bool Uniter::is_split(Index face) const {
  if (is_collapsed(corners_[face])) return false;
  if (inside_.contains(face)) return true;
  for (std::size_t i = 0; i < 3; ++i)
    if (on_edge_.contains(edge_of(corners_[face], i))) return true;
  return false;
}

std::vector<Face> Uniter::split(Index face) const {
  const Face& corners = corners_[face];
  FaceSplitter splitter(triangle(face), corners, distance_);
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<Cut> cuts = cuts_of(edge_of(corners, i));
    const bool is_up = corners[i] < corners[(i + 1) % 3];
    if (!is_up) std::reverse(cuts.begin(), cuts.end());
    for (const auto& [share, point] : cuts)
      splitter.add_on_edge(i, is_up ? share : 1 - share, point);
  }
  const auto inside = inside_.find(face);
  if (inside != inside_.end())
    for (const Index point : inside->second) splitter.add_inside(points_[point], point);
  const auto constraints = constraints_.find(face);
  if (constraints != constraints_.end())
    for (const auto& [from, to] : constraints->second) splitter.constrain(from, to);
  splitter.improve();
  return splitter.triangles();
}

// With the columns of a face that they split. What no piece needs takes those of the first vertex.
void Uniter::add_vertices(const std::vector<Face>& pieces, const std::vector<Index>& rows) {
  Mesh& mesh = assembly_.mesh;
  std::vector<Index> face_at(points_.size(), no_index);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const Index point : pieces[i]) face_at[point] = std::min(face_at[point], rows[i]);
  for (std::size_t p = soup_.points.size(); p < points_.size(); ++p) {
    mesh.positions.push_back(points_[p]);
    mesh.vertex_columns.append(face_at[p] == no_index ? RowBlend{}
                                                      : row_on_face(mesh, face_at[p], points_[p]));
    assembly_.vertex_is_new.push_back(1);
    assembly_.input_vertex.push_back(no_index);
  }
}

// Whole faces keep their order, pieces follow.
void Uniter::split_faces() {
  Mesh& mesh = assembly_.mesh;
  std::vector<Face> faces, pieces;
  std::vector<Index> rows, piece_rows;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (!is_split(f)) {
      faces.push_back(mesh.faces[f]);
      rows.push_back(f);
      continue;
    }
    for (const Face& piece : split(f)) {
      pieces.push_back(piece);
      piece_rows.push_back(f);
    }
  }
  const auto first_new = static_cast<Index>(mesh.positions.size());
  add_vertices(pieces, piece_rows);
  const auto old_points = static_cast<Index>(soup_.points.size());
  for (Face& piece : pieces)
    for (Index& v : piece) v = v < old_points ? soup_.vertex_of[v] : first_new + (v - old_points);

  std::vector<char> is_new;
  for (const Index row : rows) is_new.push_back(assembly_.face_is_new[row]);
  faces.insert(faces.end(), pieces.begin(), pieces.end());
  rows.insert(rows.end(), piece_rows.begin(), piece_rows.end());
  is_new.resize(faces.size(), 1);
  std::vector<Index> sources;
  for (const Index row : rows) sources.push_back(assembly_.source_face[row]);
  mesh.faces = std::move(faces);
  mesh.face_columns = mesh.face_columns.select(rows);
  assembly_.source_face = std::move(sources);
  assembly_.face_is_new = std::move(is_new);
}

bool Uniter::unite(const std::vector<Index>& faces) {
  std::vector<char> is_named(corners_.size(), 0);
  for (const Index f : faces) is_named[f] = 1;
  std::vector<Index> named;  // those with area
  for (const Index f : soup_.face_of)
    if (is_named[f]) named.push_back(f);
  const std::vector<Bvh::Pair> pairs = close_pairs(named);
  if (pairs.size() > most_pairs * named.size()) return false;

  for (const Index f : named)
    for (const Index point : corners_[f]) unite_corner(point, f);
  for (const auto& [i, k] : pairs) {
    const Index f = named[i], g = named[k];
    for (const Index point : corners_[f]) unite_corner(point, g);
    for (const Index point : corners_[g]) unite_corner(point, f);
    for (std::size_t e = 0; e < 9; ++e)
      unite_edges(edge_of(corners_[f], e / 3), edge_of(corners_[g], e % 3));
  }
  for (const auto& [i, k] : pairs) {
    constrain(named[i], named[k]);
    constrain(named[k], named[i]);
  }
  split_faces();
  return true;
}

}  // namespace

std::vector<Index> with_near_faces(const Mesh& mesh, const std::vector<Index>& faces,
                                   double distance) {
  const Soup soup = make_soup(mesh);
  const auto triangle = [&](Index face) {
    const auto& [a, b, c] = mesh.faces[face];
    return Triangle{mesh.positions[a], mesh.positions[b], mesh.positions[c]};
  };
  std::vector<FloatBox> boxes;
  for (const Index f : faces) boxes.push_back(box_around(soup, triangle(f), distance));
  const Bvh bvh(boxes);
  std::vector<Index> result;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    bvh.visit_overlaps(soup.box(triangle(f)), [&](Index) {
      result.push_back(f);
      return false;
    });
  }
  return result;
}

bool unite_close_parts(Assembly& assembly, const std::vector<Index>& faces,
                       const Closeness& closeness, Scalar coordinate) {
  return Uniter(assembly, closeness, coordinate).unite(faces);
}

}  // namespace transformesh
