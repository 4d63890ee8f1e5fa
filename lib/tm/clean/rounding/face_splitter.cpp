#include "tm/clean/rounding/face_splitter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace transformesh {
namespace {

/// Where the sums of two opposite cotangents are closer to zero than this, as for four points on a
/// circle, ids choose the diagonal.
constexpr long double alike = 1e-4L;

}  // namespace

FaceSplitter::FaceSplitter(const Triangle& triangle, const Face& ids, double distance)
    : triangle_(triangle), distance_(distance), ids_(ids.begin(), ids.end()), faces_{{0, 1, 2}} {
  const WidePoint along = wide(triangle[1]) - wide(triangle[0]);
  const WidePoint normal = along.cross(wide(triangle[2]) - wide(triangle[0]));
  x_axis_ = along.stableNormalized();
  y_axis_ = normal.cross(along).stableNormalized();
  for (const Vec3& corner : triangle) positions_.push_back(flat(corner));
}

FaceSplitter::PlanePoint FaceSplitter::flat(const Vec3& position) const {
  const WidePoint from = wide(position) - wide(triangle_[0]);
  return {from.dot(x_axis_), from.dot(y_axis_)};
}

// The distance of the point from the line, positive on the left of it.
long double FaceSplitter::height(const PlanePoint& point, Index from, Index to) const {
  const PlanePoint along = positions_[to] - positions_[from], up = point - positions_[from];
  const long double length = along.norm();
  return length > 0 ? (along.x() * up.y() - along.y() * up.x()) / length : up.norm();
}

long double FaceSplitter::cotangent(Index at, Index from, Index to) const {
  const PlanePoint p = positions_[from] - positions_[at], q = positions_[to] - positions_[at];
  return p.dot(q) / (p.x() * q.y() - p.y() * q.x());
}

Index FaceSplitter::add_vertex(const PlanePoint& position, Index id) {
  ids_.push_back(id);
  positions_.push_back(position);
  return static_cast<Index>(ids_.size() - 1);
}

// Splits the face at the halfedge. It keeps the first half of that, and a new face gets the second.
void FaceSplitter::split_edge(Index halfedge, Index vertex) {
  Face second = faces_[halfedge / 3];
  second[halfedge % 3] = vertex;
  faces_[halfedge / 3][(halfedge % 3 + 1) % 3] = vertex;
  faces_.push_back(second);
}

void FaceSplitter::split_face(std::size_t face, Index vertex) {
  const Face f = faces_[face];
  faces_[face] = {f[0], f[1], vertex};
  faces_.push_back({f[1], f[2], vertex});
  faces_.push_back({f[2], f[0], vertex});
}

void FaceSplitter::add_on_edge(std::size_t edge, double share, Index id) {
  const auto from = static_cast<Index>(edge), to = (from + 1) % 3;
  const Index rest = find_halfedges().at({last_[edge], to});
  const PlanePoint along = positions_[to] - positions_[from];
  last_[edge] = add_vertex(positions_[from] + static_cast<long double>(share) * along, id);
  split_edge(rest, last_[edge]);
}

std::size_t FaceSplitter::face_around(const PlanePoint& point) const {
  std::size_t best = 0;
  long double deepest = -std::numeric_limits<long double>::infinity();
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const auto& [a, b, c] = faces_[f];
    const long double depth =
        std::min({height(point, a, b), height(point, b, c), height(point, c, a)});
    if (depth <= deepest) continue;
    deepest = depth;
    best = f;
  }
  return best;
}

// An edge between two faces to which the point in the face is close; no_index where there is none.
Index FaceSplitter::near_edge(std::size_t face, const PlanePoint& point,
                              const Halfedges& halfedges) const {
  for (Index i = 0; i < 3; ++i) {
    const Index a = faces_[face][i], b = faces_[face][(i + 1) % 3];
    if (height(point, a, b) <= distance_ && halfedges.contains({b, a}))
      return static_cast<Index>(3 * face) + i;
  }
  return no_index;
}

void FaceSplitter::add_inside(const Vec3& position, Index id) {
  if (std::find(ids_.begin(), ids_.end(), id) != ids_.end()) return;
  const PlanePoint point = flat(position);
  const std::size_t face = face_around(point);
  const Halfedges halfedges = find_halfedges();
  const Index cut = near_edge(face, point, halfedges);
  const Index vertex = add_vertex(point, id);
  if (cut == no_index) {
    split_face(face, vertex);
    return;
  }
  const Index a = faces_[face][cut % 3], b = faces_[face][(cut % 3 + 1) % 3];
  split_edge(halfedges.at({b, a}), vertex);
  split_edge(cut, vertex);
}

FaceSplitter::Halfedges FaceSplitter::find_halfedges() const {
  Halfedges halfedges;
  for (Index f = 0; f < faces_.size(); ++f)
    for (Index i = 0; i < 3; ++i) halfedges[{faces_[f][i], faces_[f][(i + 1) % 3]}] = 3 * f + i;
  return halfedges;
}

FaceSplitter::Quad FaceSplitter::quad_at(Index halfedge, Index across) const {
  const Face &left = faces_[halfedge / 3], &right = faces_[across / 3];
  return {left[halfedge % 3], right[across % 3], left[(halfedge % 3 + 2) % 3],
          right[(across % 3 + 2) % 3]};
}

bool FaceSplitter::is_convex(const Quad& q) const {
  return height(positions_[q.b], q.c, q.d) > 0 && height(positions_[q.a], q.d, q.c) > 0;
}

bool FaceSplitter::wants_flip(const Quad& q) const {
  if (constrained_.contains(std::minmax(q.a, q.b)) || !is_convex(q)) return false;
  const long double now = cotangent(q.c, q.a, q.b) + cotangent(q.d, q.b, q.a);
  const long double then = cotangent(q.a, q.d, q.c) + cotangent(q.b, q.c, q.d);
  if (std::abs(now) < alike && std::abs(then) < alike)
    return std::min(ids_[q.c], ids_[q.d]) < std::min(ids_[q.a], ids_[q.b]);
  return now < 0 && then > now;
}

void FaceSplitter::flip(Index halfedge, Index across, const Quad& q) {
  faces_[halfedge / 3] = {q.c, q.d, q.b};
  faces_[across / 3] = {q.d, q.c, q.a};
}

bool FaceSplitter::flip_all() {
  bool is_flipped = false;
  Halfedges halfedges = find_halfedges();
  for (Index h = 0; h < 3 * faces_.size(); ++h) {
    const Face& face = faces_[h / 3];
    const auto across = halfedges.find({face[(h % 3 + 1) % 3], face[h % 3]});
    if (across == halfedges.end()) continue;
    const Quad quad = quad_at(h, across->second);
    if (!wants_flip(quad)) continue;
    flip(h, across->second, quad);
    halfedges = find_halfedges();
    is_flipped = true;
  }
  return is_flipped;
}

void FaceSplitter::improve() {
  for (std::size_t round = 0; round < 2 * ids_.size() && flip_all(); ++round) {
  }
}

bool FaceSplitter::crosses(Index from, Index to, Index a, Index b) const {
  if (a == from || a == to || b == from || b == to) return false;
  const auto is_left = [&](Index point, Index start, Index end) {
    return height(positions_[point], start, end) > 0;
  };
  return is_left(a, from, to) != is_left(b, from, to) && is_left(from, a, b) != is_left(to, a, b);
}

// Flips one edge that crosses the segment, and returns whether there was one to flip. Edges whose
// flip clears the segment go first. Where there is none, the choice depends on the step, so that no
// edge is flipped back and forth.
bool FaceSplitter::step_towards(Index from, Index to, std::size_t step) {
  const Halfedges halfedges = find_halfedges();
  std::vector<std::pair<Index, Index>> crossing, clearing;
  for (const auto& [ends, h] : halfedges) {
    const auto across = halfedges.find({ends.second, ends.first});
    if (ends.first > ends.second || across == halfedges.end()) continue;
    if (!crosses(from, to, ends.first, ends.second)) continue;
    if (constrained_.contains(ends)) return false;
    const Quad quad = quad_at(h, across->second);
    if (!is_convex(quad)) continue;
    (crosses(from, to, quad.c, quad.d) ? crossing : clearing).emplace_back(h, across->second);
  }
  const auto& candidates = clearing.empty() ? crossing : clearing;
  if (candidates.empty()) return false;
  const auto& [h, across] = candidates[step % candidates.size()];
  flip(h, across, quad_at(h, across));
  return true;
}

void FaceSplitter::constrain(Index from_id, Index to_id) {
  const auto from = static_cast<Index>(std::find(ids_.begin(), ids_.end(), from_id) - ids_.begin());
  const auto to = static_cast<Index>(std::find(ids_.begin(), ids_.end(), to_id) - ids_.begin());
  if (from == ids_.size() || to == ids_.size()) return;
  for (std::size_t step = 0; step < 4 * faces_.size(); ++step) {
    const Halfedges halfedges = find_halfedges();
    if (halfedges.contains({from, to}) || halfedges.contains({to, from})) {
      constrained_.insert(std::minmax(from, to));
      return;
    }
    if (!step_towards(from, to, step)) return;
  }
}

std::vector<Face> FaceSplitter::triangles() const {
  std::vector<Face> result;
  for (const Face& f : faces_) {
    const Face named = {ids_[f[0]], ids_[f[1]], ids_[f[2]]};
    if (!is_collapsed(named)) result.push_back(named);
  }
  return result;
}

}  // namespace transformesh
