#include "remesh/operations/vertex_mover.h"

#include <algorithm>

namespace transformesh {
namespace {

constexpr double least_motion_cosine = 0.5;  ///< cosine of 60 degrees; chosen by hand, not measured
/// The normal of a triangle of at most this roundness is mostly rounding error.
constexpr double least_normal_roundness = 0.02;
/// Triangles with a smaller squared roundness have no reliable normal (normal_cone.h).
constexpr double thin = 1e-16;

/// Returns the squares of roundness() (triangle_quality.h) of two triangles.
NumberPair squared_roundness(NumberPair normal_squared, NumberPair squares) {
  return squares > twice(0) ? 12 * normal_squared / (squares * squares) : twice(0);
}

/// Returns the squared roundness of the least round triangle of the star.
double least_squared_roundness(const VertexStar& star) {
  NumberPair least = twice(1);
  for (std::size_t k = 0; k < star.pair_count(); ++k) {
    const VertexStar::Pair& pair = star.pairs()[k];
    const NumberPair roundness = squared_roundness(pair.squared, pair.squares);
    least = lesser(least, star.is_there(k) ? roundness : twice(1));
  }
  return std::min(least[0], least[1]);
}

/// Returns the normals with which new normals are compared. These are the old normals, or the
/// normal of the whole star if the old normals are mostly rounding error.
NormalPair normals_before(const VertexStar& star, const VertexStar::Pair& pair) {
  const NumberPair bound =
      twice(least_normal_roundness * least_normal_roundness) * pair.squares * pair.squares;
  const MaskPair has_normal = 12 * pair.squared > bound;
  if (all(has_normal)) return {pair.normal, pair.squared};
  const VectorPair mean = twice_vector(star.normal());
  return {{has_normal ? pair.normal.x : mean.x, has_normal ? pair.normal.y : mean.y,
           has_normal ? pair.normal.z : mean.z},
          has_normal ? pair.squared : mean.squared()};
}

/// Computes turns() (triangle_quality.h) for two triangles.
MaskPair turn(const NormalPair& before, const NormalPair& after) {
  const NumberPair dot = before.normal.dot(after.normal);
  const NumberPair bound =
      twice(least_motion_cosine * least_motion_cosine) * before.squared * after.squared;
  return (dot <= twice(0)) | (dot * dot < bound);
}

}  // namespace

bool VertexMover::move(Index vertex, const VertexStar& star, const Vec3& target) {
  return attempt(vertex, star, target) || attempt(vertex, star, 0.5 * star.center() + 0.5 * target);
}

void VertexMover::place_ways(const VertexStar& star, const Vec3& target) {
  const std::size_t needed = star.ring().size() / 2 + 1;
  if (ways_.size() < needed) {
    ways_.resize(2 * needed);
    normals_.resize(2 * needed);
  }
  const VectorPair center = twice_vector(target);
  WayPair* const ways = ways_.data();
  for (std::size_t k = 0; 2 * k < star.ring().size(); ++k) {
    ways[k].way = star.pairs()[k].rim - center;
    ways[k].squared = ways[k].way.squared();
  }
}

/// Computes the normals after the move. Returns false if a triangle turns too far or becomes too
/// narrow.
bool VertexMover::place_triangles(const VertexStar& star, const Vec3& target) {
  place_ways(star, target);
  const WayPair* const ways = ways_.data();
  NormalPair* const normals = normals_.data();
  MaskPair turned = {0, 0};
  NumberPair least = twice(1);
  NumberPair longest = twice(ways[0].squared[0]);
  for (std::size_t k = 0; k < star.pair_count(); ++k) {
    const VertexStar::Pair& pair = star.pairs()[k];
    const MaskPair is_there = star.is_there(k);
    const VectorPair b = middle(ways[k].way, ways[k + 1].way);
    const NumberPair b_squared = middle(ways[k].squared, ways[k + 1].squared);
    const VectorPair normal = ways[k].way.cross(b);
    normals[k] = {normal, normal.squared()};
    turned |= is_there & turn(normals_before(star, pair), normals[k]);
    const NumberPair squares = ways[k].squared + b_squared + pair.across_squared;
    const NumberPair roundness = squared_roundness(normals[k].squared, squares);
    least = lesser(least, is_there ? roundness : twice(1));
    longest = greater(longest, is_there ? greater(b_squared, pair.across_squared) : twice(0));
  }
  if (any(turned)) return false;
  patch_.longest_squared = std::max(longest[0], longest[1]);
  const double least_now = std::min(least[0], least[1]);
  has_thin_ = least_now < thin;
  return least_now >= enough_ * enough_ || least_now >= least_squared_roundness(star);
}

void VertexMover::name_vertices(Index vertex, const VertexStar& star) {
  const std::span<const Index> ring = star.ring();
  patch_.center = vertex;
  patch_.reach_squared = star.reach_squared();
  patch_.vertices.resize(ring.size() + 1);
  patch_.vertices[0] = vertex;
  const std::size_t repeated = ring.front() == ring.back() ? 1 : 0;
  std::copy(ring.begin() + repeated, ring.end(), patch_.vertices.begin() + 1);
  patch_.vertices.resize(ring.size() + 1 - repeated);
}

void VertexMover::name_faces(Index vertex, const VertexStar& star, const Vec3& target) {
  for (std::size_t i = 0; i < star.size(); ++i) {
    const VectorPair& normal = normals_[i / 2].normal;
    patch_.normals.emplace_back(normal.x[i % 2], normal.y[i % 2], normal.z[i % 2]);
    patch_.made.push_back({target, star.rim(i), star.rim(i + 1)});
  }
  mesh_.for_each_outgoing(vertex, [&](Index halfedge) { patch_.replaced.push_back(halfedge / 3); });
}

// The certificate of the embedding guard does not need the list of faces, so the list is made only
// if the certificate fails.
bool VertexMover::is_allowed(Index vertex, const VertexStar& star, const Vec3& target) {
  if (!place_triangles(star, target)) return false;
  patch_.clear();
  patch_.center_position = target;
  name_vertices(vertex, star);
  patch_.cone = has_thin_ ? 0 : common_cone(normals_, star.size());
  if (guard_.certifies(patch_)) return true;
  name_faces(vertex, star, target);
  return guard_.allows_uncertified(patch_);
}

bool VertexMover::attempt(Index vertex, const VertexStar& star, const Vec3& wanted) {
  const Vec3 target = mesh_.rounded(wanted);
  if (!is_allowed(vertex, star, target)) return false;
  mesh_.move(vertex, target);
  guard_.commit(patch_);
  return true;
}

}  // namespace transformesh
