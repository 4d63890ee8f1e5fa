#include "tm/remesh/vertex_mover.h"

#include <algorithm>

namespace transformesh {
namespace {

constexpr double least_turn_cosine = 0.5;
/// Triangles at least this round are good enough; others must not get worse.
constexpr double round_enough = 0.6;
/// The normal of a triangle that is no rounder than this is mostly rounding error.
constexpr double normal_roundness = 0.02;

/// The square of roundness() in star.h.
double squared_roundness(const Vec3& normal, double squares) {
  return squares > 0 ? 12 * normal.squaredNorm() / (squares * squares) : 0;
}

bool has_normal(const Star::Spoke& spoke) {
  return 12 * spoke.normal.squaredNorm() >
         normal_roundness * normal_roundness * spoke.squares * spoke.squares;
}

/// The squared roundness of the narrowest triangle.
double least_squared_roundness(const Star& star) {
  double least = 1;
  for (const Star::Spoke& spoke : star.spokes)
    least = std::min(least, squared_roundness(spoke.normal, spoke.squares));
  return least;
}

}  // namespace

void Star::gather(const EditableMesh& mesh, Index vertex) {
  spokes.clear();
  normal.setZero();
  center = mesh.position(vertex);
  Index first = mesh.target(mesh.outgoing(vertex));
  Vec3 a = mesh.position(first) - center;
  double a_squared = a.squaredNorm();
  mesh.for_each_outgoing(vertex, [&](Index halfedge) {
    const Index second = mesh.apex(halfedge);
    const Vec3 b = mesh.position(second) - center;
    const double b_squared = b.squaredNorm();
    const double rim = (b - a).squaredNorm();
    const Vec3 own = a.cross(b);
    spokes.push_back({first, halfedge / 3, mesh.position(first), mesh.position(second), own, rim,
                      a_squared + b_squared + rim});
    normal += own;
    first = second;
    a = b;
    a_squared = b_squared;
  });
}

bool VertexMover::move(Index vertex, const Star& star, const Vec3& target) {
  return attempt(vertex, star, target) || attempt(vertex, star, 0.5 * star.center + 0.5 * target);
}

/// Fills the patch's triangles; false where one turns over or gets too narrow.
bool VertexMover::place_triangles(const Star& star, const Vec3& target) {
  patch_.clear();
  double least = 1;
  Vec3 a = star.spokes[0].first_position - target;
  double a_squared = a.squaredNorm();
  patch_.longest_squared = a_squared;
  for (const Star::Spoke& spoke : star.spokes) {
    const Vec3 b = spoke.second_position - target;
    const double b_squared = b.squaredNorm();
    const Vec3 normal = a.cross(b);
    const Vec3& before = has_normal(spoke) ? spoke.normal : star.normal;
    if (turns(before, normal, least_turn_cosine)) return false;
    least = std::min(least, squared_roundness(normal, a_squared + b_squared + spoke.rim));
    patch_.longest_squared = std::max({patch_.longest_squared, b_squared, spoke.rim});
    patch_.made.push_back({target, spoke.first_position, spoke.second_position});
    patch_.normals.push_back(normal);
    a = b;
    a_squared = b_squared;
  }
  return least >= round_enough * round_enough || least >= least_squared_roundness(star);
}

void VertexMover::name_parts(Index vertex, const Star& star) {
  patch_.center = vertex;
  patch_.vertices.push_back(vertex);
  for (const Star::Spoke& spoke : star.spokes) {
    patch_.vertices.push_back(spoke.first);
    patch_.replaced.push_back(spoke.face);
  }
  if (!mesh_.is_border_vertex(vertex)) return;
  // The last face has the vertex that ends the fan.
  for (Index corner = 0; corner < 3; ++corner)
    patch_.vertices.push_back(mesh_.source(3 * star.spokes.back().face + corner));
}

bool VertexMover::attempt(Index vertex, const Star& star, const Vec3& wanted) {
  const Vec3 target = mesh_.rounded(wanted);
  if (!place_triangles(star, target)) return false;
  patch_.center_position = target;
  name_parts(vertex, star);
  if (!guard_.allows(patch_)) return false;
  mesh_.move(vertex, target);
  guard_.commit(patch_);
  return true;
}

}  // namespace transformesh
