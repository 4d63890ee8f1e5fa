#include "tm/remesh/vertex_mover.h"

#include <algorithm>

namespace transformesh {
namespace {

constexpr double least_turn_cosine = 0.5;
/// The normal of a triangle that is no rounder than this is mostly rounding error.
constexpr double normal_roundness = 0.02;

/// The square of roundness() in star.h.
double squared_roundness(double normal_squared, double squares) {
  return squares > 0 ? 12 * normal_squared / (squares * squares) : 0;
}

bool has_normal(const Star::Triangle& triangle) {
  return 12 * triangle.normal_squared >
         normal_roundness * normal_roundness * triangle.squares * triangle.squares;
}

/// The squared roundness of the narrowest triangle.
double least_squared_roundness(const Star& star) {
  double least = 1;
  for (const Star::Triangle& triangle : star.triangles)
    least = std::min(least, squared_roundness(triangle.normal_squared, triangle.squares));
  return least;
}

}  // namespace

void Star::gather(const EditableMesh& mesh, Index vertex) {
  find_ring(mesh, vertex, own_ring_);
  gather(mesh, vertex, own_ring_);
}

// Sums are kept out of the star meanwhile, where the compiler would have to write them each time.
void Star::gather(const EditableMesh& mesh, Index vertex, std::span<const Index> neighbors) {
  triangles.clear();
  rim.clear();
  const Vec3 middle = mesh.position(vertex);
  rim.push_back(mesh.position(neighbors[0]));
  Vec3 a = rim[0] - middle;
  double a_squared = a.squaredNorm();
  double farthest = a_squared;
  Vec3 sum = Vec3::Zero();
  for (const Index neighbor : neighbors.subspan(1)) {
    const Vec3& end = mesh.position(neighbor);
    const Vec3 b = end - middle;
    const double b_squared = b.squaredNorm();
    const double across_squared = (b - a).squaredNorm();
    const Vec3 own = a.cross(b);
    triangles.push_back(
        {own, own.squaredNorm(), across_squared, a_squared + b_squared + across_squared});
    rim.push_back(end);
    sum += own;
    farthest = std::max(farthest, b_squared);
    a = b;
    a_squared = b_squared;
  }
  ring = neighbors;
  center = middle;
  normal = sum;
  reach_squared = farthest;
}

bool VertexMover::move(Index vertex, const Star& star, const Vec3& target) {
  return attempt(vertex, star, target) || attempt(vertex, star, 0.5 * star.center + 0.5 * target);
}

/// Fills the patch's normals; false where a triangle turns over or gets too narrow.
bool VertexMover::place_triangles(const Star& star, const Vec3& target) {
  patch_.clear();
  double least = 1;
  Vec3 a = star.rim[0] - target;
  double a_squared = a.squaredNorm();
  double longest_squared = a_squared;
  for (std::size_t i = 0; i < star.triangles.size(); ++i) {
    const Star::Triangle& triangle = star.triangles[i];
    const Vec3 b = star.rim[i + 1] - target;
    const double b_squared = b.squaredNorm();
    const Vec3 normal = a.cross(b);
    const double normal_squared = normal.squaredNorm();
    const bool is_narrow = !has_normal(triangle);
    const Vec3& before = is_narrow ? star.normal : triangle.normal;
    const double before_squared = is_narrow ? star.normal.squaredNorm() : triangle.normal_squared;
    const double dot = before.dot(normal);
    if (turns(dot, before_squared, normal_squared, least_turn_cosine)) return false;
    least = std::min(
        least, squared_roundness(normal_squared, a_squared + b_squared + triangle.across_squared));
    longest_squared = std::max({longest_squared, b_squared, triangle.across_squared});
    patch_.normals.push_back(normal);
    a = b;
    a_squared = b_squared;
  }
  patch_.longest_squared = longest_squared;
  return least >= enough_ * enough_ || least >= least_squared_roundness(star);
}

void VertexMover::name_vertices(Index vertex, const Star& star) {
  patch_.center = vertex;
  patch_.reach_squared = star.reach_squared;
  patch_.vertices.push_back(vertex);
  const std::size_t repeated = star.ring.front() == star.ring.back() ? 1 : 0;
  patch_.vertices.insert(patch_.vertices.end(), star.ring.begin() + repeated, star.ring.end());
}

void VertexMover::name_faces(Index vertex, const Star& star, const Vec3& target) {
  for (std::size_t i = 0; i < star.triangles.size(); ++i)
    patch_.made.push_back({target, star.rim[i], star.rim[i + 1]});
  mesh_.for_each_outgoing(vertex, [&](Index halfedge) { patch_.replaced.push_back(halfedge / 3); });
}

// What the certificate does not look at is found where that says no.
bool VertexMover::is_allowed(Index vertex, const Star& star, const Vec3& target) {
  if (!place_triangles(star, target)) return false;
  patch_.center_position = target;
  name_vertices(vertex, star);
  if (guard_.certifies(patch_)) return true;
  name_faces(vertex, star, target);
  return guard_.allows_uncertified(patch_);
}

bool VertexMover::attempt(Index vertex, const Star& star, const Vec3& wanted) {
  const Vec3 target = mesh_.rounded(wanted);
  if (!is_allowed(vertex, star, target)) return false;
  mesh_.move(vertex, target);
  guard_.commit(patch_);
  return true;
}

}  // namespace transformesh
