#include "tm/remesh/vertex_mover.h"

#include <algorithm>

namespace transformesh {
namespace {

constexpr double least_turn_cosine = 0.5;
/// Triangles at least this round are good enough; others must not get worse.
constexpr double round_enough = 0.6;
/// A triangle rounder than this has a normal to rely on.
constexpr double has_normal = 0.02;

/// Whether no triangle turns over or gets too narrow.
bool is_sound(const Star& star, const Vec3& target) {
  double before = round_enough;
  double after = 1;
  for (const Star::Spoke& spoke : star.spokes) {
    const Vec3& a = spoke.first_position;
    const Vec3& b = spoke.second_position;
    const double round = roundness(star.centre, a, b);
    before = std::min(before, round);
    after = std::min(after, roundness(target, a, b));
    const Vec3& normal = round > has_normal ? normal_of(star.centre, a, b) : star.normal;
    if (turns(normal, normal_of(target, a, b), least_turn_cosine)) return false;
  }
  return after >= before;
}

}  // namespace

void Star::gather(const EditableMesh& mesh, Index vertex) {
  spokes.clear();
  normal.setZero();
  centre = mesh.position(vertex);
  mesh.for_each_outgoing(vertex, [&](Index halfedge) {
    const Index first = mesh.target(halfedge);
    spokes.push_back({first, mesh.position(first), mesh.position(mesh.apex(halfedge))});
    normal += normal_of(centre, spokes.back().first_position, spokes.back().second_position);
  });
}

bool VertexMover::move(Index vertex, const Star& star, const Vec3& target) {
  return attempt(vertex, star, target) || attempt(vertex, star, 0.5 * star.centre + 0.5 * target);
}

bool VertexMover::attempt(Index vertex, const Star& star, const Vec3& wanted) {
  const Vec3 target = mesh_.rounded(wanted);
  if (!is_sound(star, target)) return false;
  patch_.clear();
  patch_.centre = vertex;
  patch_.centre_position = target;
  patch_.vertices.push_back(vertex);
  for (const Star::Spoke& spoke : star.spokes) {
    patch_.made.push_back({target, spoke.first_position, spoke.second_position});
    patch_.vertices.push_back(spoke.first);
  }
  mesh_.for_each_outgoing(vertex, [&](Index h) { patch_.replaced.push_back(h / 3); });
  if (mesh_.is_border_vertex(vertex)) {
    patch_.vertices.push_back(mesh_.source(3 * patch_.replaced.back()));  // last of the fan
    patch_.vertices.push_back(mesh_.source(3 * patch_.replaced.back() + 1));
    patch_.vertices.push_back(mesh_.source(3 * patch_.replaced.back() + 2));
  }
  if (!guard_.allows(patch_)) return false;
  mesh_.move(vertex, target);
  guard_.commit(patch_);
  return true;
}

}  // namespace transformesh
