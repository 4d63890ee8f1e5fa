#include "tm/remesh/vertex_mover.h"

#include <algorithm>

namespace transformesh {
namespace {

constexpr double least_turn_cosine = 0.5;
/// Triangles at least this round are good enough; others must not get worse.
constexpr double round_enough = 0.6;
/// A triangle rounder than this has a normal to rely on.
constexpr double has_normal = 0.02;

/// The squared roundness (star.h) of the flattest triangle around a centre.
double least_squared_roundness(const Star& star, const Vec3& centre) {
  double least = 1;
  for (const Star::Spoke& spoke : star.spokes) {
    const Vec3 a = spoke.first_position - centre;
    const Vec3 b = spoke.second_position - centre;
    const double squares = a.squaredNorm() + b.squaredNorm() + (b - a).squaredNorm();
    const double area = a.cross(b).squaredNorm();
    least = std::min(least, squares > 0 ? 12 * area / (squares * squares) : 0);
  }
  return least;
}

bool has_own_normal(const Star::Spoke& spoke, const Vec3& centre) {
  const Vec3 a = spoke.first_position - centre;
  const Vec3 b = spoke.second_position - centre;
  const double squares = a.squaredNorm() + b.squaredNorm() + (b - a).squaredNorm();
  return 12 * spoke.normal.squaredNorm() > has_normal * has_normal * squares * squares;
}

/// Whether no triangle gets too narrow.
bool is_round(const Star& star, const Vec3& target) {
  const double after = least_squared_roundness(star, target);
  if (after >= round_enough * round_enough) return true;
  return after >= least_squared_roundness(star, star.centre);
}

}  // namespace

void Star::gather(const EditableMesh& mesh, Index vertex) {
  spokes.clear();
  normal.setZero();
  centre = mesh.position(vertex);
  mesh.for_each_outgoing(vertex, [&](Index halfedge) {
    const Index first = mesh.target(halfedge);
    const Vec3& a = mesh.position(first);
    const Vec3& b = mesh.position(mesh.apex(halfedge));
    const Vec3 own = normal_of(centre, a, b);
    spokes.push_back({first, halfedge / 3, a, b, own});
    normal += own;
  });
}

bool VertexMover::move(Index vertex, const Star& star, const Vec3& target) {
  return attempt(vertex, star, target) || attempt(vertex, star, 0.5 * star.centre + 0.5 * target);
}

/// Fills the patch's triangles; false where one turns over.
bool VertexMover::place_triangles(const Star& star, const Vec3& target) {
  patch_.clear();
  for (const Star::Spoke& spoke : star.spokes) {
    const Vec3 normal = normal_of(target, spoke.first_position, spoke.second_position);
    const Vec3& before = has_own_normal(spoke, star.centre) ? spoke.normal : star.normal;
    if (turns(before, normal, least_turn_cosine)) return false;
    patch_.made.push_back({target, spoke.first_position, spoke.second_position});
    patch_.normals.push_back(normal);
  }
  return true;
}

void VertexMover::name_parts(Index vertex, const Star& star) {
  patch_.centre = vertex;
  patch_.vertices.push_back(vertex);
  for (const Star::Spoke& spoke : star.spokes) {
    patch_.vertices.push_back(spoke.first);
    patch_.replaced.push_back(spoke.face);
  }
  if (!mesh_.is_border_vertex(vertex)) return;
  for (Index corner = 0; corner < 3; ++corner)  // one of them ends the fan
    patch_.vertices.push_back(mesh_.source(3 * star.spokes.back().face + corner));
}

bool VertexMover::attempt(Index vertex, const Star& star, const Vec3& wanted) {
  const Vec3 target = mesh_.rounded(wanted);
  if (!is_round(star, target) || !place_triangles(star, target)) return false;
  patch_.centre_position = target;
  name_parts(vertex, star);
  if (!guard_.allows(patch_)) return false;
  mesh_.move(vertex, target);
  guard_.commit(patch_);
  return true;
}

}  // namespace transformesh
