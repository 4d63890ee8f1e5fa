#include "tm/clean/rounding/unite_close.h"

#include <algorithm>
#include <cmath>

#include "tm/clean/intersect/welded_mesh.h"
#include "tm/clean/rounding/face_cuts.h"
#include "tm/clean/rounding/face_splitter.h"
#include "tm/geometry/bvh.h"

namespace transformesh {
namespace {

// The most pairs of close faces, per face. Where more pass one place, uniting each with each makes
// more slivers than it mends.
constexpr std::size_t most_pairs = 30;

bool is_short(const WidePoint& step, const Vec3& reach) {
  return (step.cwiseAbs().array() <= wide(reach).array()).all();
}

// Whether the point is that close to the interior of the triangle.
bool is_over(const Triangle& t, const Vec3& point, const Vec3& reach) {
  const WidePoint a = wide(t[0]), p = wide(point);
  const WidePoint normal = (wide(t[1]) - a).cross(wide(t[2]) - a).stableNormalized();
  if (!is_short((p - a).dot(normal) * normal, reach)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const WidePoint from = wide(t[i]), to = wide(t[(i + 1) % 3]);
    if (!((to - from).cross(p - from).dot(normal) > 0)) return false;
  }
  return true;
}

// Where two segments come closest, as shares of their lengths. If they are parallel, at their
// starts.
std::array<long double, 2> closest_shares(const Vec3& a, const Vec3& b, const Vec3& c,
                                          const Vec3& d) {
  const WidePoint u = wide(b) - wide(a), v = wide(d) - wide(c), w = wide(a) - wide(c);
  const long double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), uw = u.dot(w), vw = v.dot(w);
  const long double determinant = uu * vv - uv * uv;
  if (!(determinant > 0)) return {0, 0};
  return {(uv * vw - vv * uw) / determinant, (uu * vw - uv * uw) / determinant};
}

FloatBox box_with_reach(const WeldedMesh& welded, const Triangle& t, double distance) {
  const Vec3 reach = Vec3::Constant(distance);
  return welded.frame.box(t[0].cwiseMin(t[1]).cwiseMin(t[2]) - reach,
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
  void unite_faces(Index face, Index other);

  const WeldedMesh welded_;
  const Closeness closeness_;
  const double distance_;
  int largest_ = 0;  ///< the exponent of the largest coordinate
  FaceCuts cuts_;
};

Uniter::Uniter(Assembly& assembly, const Closeness& closeness, Scalar coordinate)
    : welded_(weld(assembly.mesh)),
      closeness_(closeness),
      distance_(closeness.distance),
      cuts_(assembly, welded_, coordinate) {
  double largest = 0;
  for (const Vec3& p : welded_.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  largest_ = std::ilogb(largest);
}

std::vector<Bvh::Pair> Uniter::close_pairs(const std::vector<Index>& faces) const {
  std::vector<FloatBox> boxes;
  boxes.reserve(faces.size());
  for (const Index f : faces)
    boxes.push_back(box_with_reach(welded_, cuts_.triangle(f), distance_));
  return Bvh(boxes).overlapping_pairs([](Index, Index) { return true; });
}

// How close parts must be along each axis to be united, given the size of their coordinates there.
Vec3 Uniter::reach_of(const Vec3& size) const {
  if (!closeness_.is_local) return Vec3::Constant(distance_);
  return size.unaryExpr([&](double x) {
    const int exponent = x > 0 ? std::max(std::ilogb(x) - largest_, -20) : -20;
    return std::ldexp(distance_, exponent);
  });
}

Vec3 Uniter::reach_at(std::initializer_list<Index> points) const {
  Vec3 size = Vec3::Zero();
  for (const Index p : points) size = size.cwiseMax(cuts_.position(p).cwiseAbs());
  return reach_of(size);
}

// Whether the point is close to the interior of the edge, and at which share of its length.
bool Uniter::is_beside(const PointPair& edge, Index point, double& share) const {
  if (point == edge[0] || point == edge[1]) return false;
  const WidePoint from = wide(cuts_.position(edge[0]));
  const WidePoint along = wide(cuts_.position(edge[1])) - from,
                  to = wide(cuts_.position(point)) - from;
  const long double at = to.dot(along) / along.dot(along);
  share = static_cast<double>(at);
  return at > 0 && at < 1 && is_short(to - at * along, reach_at({edge[0], edge[1], point}));
}

void Uniter::unite_corner(Index point, Index face) {
  const Face& corners = cuts_.corners(face);
  bool is_on_edge = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const PointPair edge = edge_of(corners, i);
    double share = 0;
    if (!is_beside(edge, point, share)) continue;
    cuts_.add_on_edge(edge, share, point);
    is_on_edge = true;
  }
  if (is_on_edge || std::count(corners.begin(), corners.end(), point) > 0) return;
  const Vec3 reach = reach_at({corners[0], corners[1], corners[2], point});
  if (is_over(cuts_.triangle(face), cuts_.position(point), reach)) cuts_.add_inside(face, point);
}

// Whether an end of one edge is close to the other edge. Then that end splits the edge, and no new
// point is needed.
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
  const Vec3 &a = cuts_.position(first[0]), &b = cuts_.position(first[1]);
  const Vec3 &c = cuts_.position(second[0]), &d = cuts_.position(second[1]);
  const auto [s, t] = closest_shares(a, b, c, d);
  if (!(s > 0 && s < 1 && t > 0 && t < 1)) return;
  const WidePoint p = wide(a) + s * (wide(b) - wide(a)), q = wide(c) + t * (wide(d) - wide(c));
  const Vec3 reach = reach_at({first[0], first[1], second[0], second[1]});
  const auto is_near = [&](const WidePoint& x, const WidePoint& y) {
    return is_short(x - y, reach);
  };
  if (!is_near(p, q) || is_near(p, wide(a)) || is_near(p, wide(b)) || is_near(q, wide(c)) ||
      is_near(q, wide(d)))
    return;
  const Index point = cuts_.point_between(first, second, ((p + q) / 2).cast<double>());
  cuts_.add_on_edge(first, static_cast<double>(s), point);
  cuts_.add_on_edge(second, static_cast<double>(t), point);
}

void Uniter::unite_faces(Index face, Index other) {
  for (const Index point : cuts_.corners(face)) unite_corner(point, other);
  for (const Index point : cuts_.corners(other)) unite_corner(point, face);
  for (std::size_t e = 0; e < 9; ++e)
    unite_edges(edge_of(cuts_.corners(face), e / 3), edge_of(cuts_.corners(other), e % 3));
}

bool Uniter::unite(const std::vector<Index>& faces) {
  std::vector<char> is_named(cuts_.faces(), 0);
  for (const Index f : faces) is_named[f] = 1;
  std::vector<Index> named;  // without those that have no area
  for (const Index f : welded_.face_of)
    if (is_named[f]) named.push_back(f);
  const std::vector<Bvh::Pair> pairs = close_pairs(named);
  if (pairs.size() > most_pairs * named.size()) return false;

  for (const Index f : named)
    for (const Index point : cuts_.corners(f)) unite_corner(point, f);
  for (const auto& [i, k] : pairs) unite_faces(named[i], named[k]);
  for (const auto& [i, k] : pairs) {
    cuts_.constrain(named[i], named[k]);
    cuts_.constrain(named[k], named[i]);
  }
  cuts_.split_faces(distance_);
  return true;
}

}  // namespace

std::vector<Index> with_near_faces(const Mesh& mesh, const std::vector<Index>& faces,
                                   double distance) {
  const WeldedMesh welded = weld(mesh);
  std::vector<FloatBox> boxes;
  boxes.reserve(faces.size());
  for (const Index f : faces)
    boxes.push_back(box_with_reach(welded, triangle_of(mesh, f), distance));
  const Bvh bvh(boxes);
  std::vector<Index> result;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    bvh.visit_overlaps(welded.box(triangle_of(mesh, f)), [&](Index) {
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
