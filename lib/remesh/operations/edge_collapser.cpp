#include "remesh/operations/edge_collapser.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "remesh/halfedges/triangle_quality.h"
#include "remesh/operations/curved_edge.h"

namespace transformesh {
namespace {

constexpr double least_turn_cosine = 0.5;  ///< cosine of 60 degrees; chosen by hand, not measured
/// A collapse is allowed if all its triangles have at least this roundness, or if none becomes less
/// round.
constexpr double round_enough = 0.3;
/// Least roundness for collapse_to(), where the shape of the surface matters more than the shape of
/// triangles.
constexpr double round_enough_for_shape = 0.001;
/// The normal of a triangle of at most this roundness is not reliable. New normals are then
/// compared with the mean normal of the star instead. Remeshing makes narrow triangles wider,
/// whatever their directions. In decimation, narrow triangles are often exact, and their normals
/// count. With 0.02 instead of 1e-6, no edge of a double cone with 600 sides and heights of 3 and
/// 0.2 collapsed.
constexpr double normal_roundness = 0.02;
constexpr double normal_roundness_for_shape = 1e-6;
/// Limits for vertices of high valence, whose triangles are all narrow. Each collapse may make
/// triangles narrower and squared lengths longer by these factors. Long edges are split afterwards.
constexpr double narrowing_of_stars = 0.5;
constexpr double stretch_of_stars = 1.02;
/// Under ShapeRules::curved, a collapse may make edges only as long as the longest allowed length
/// minus this share of the length of the collapsed edge. A flow that stretches the surface would
/// soon split longer edges again, and each split interpolates. In Enright's test with 5,000 faces,
/// 0.3 and 0.75 give about the same error; 1 gives 1.4 times the Hausdorff distance.
constexpr double room_to_stretch = 0.5;
/// Under ShapeRules::curved and without min_film, collapses move the surface by at most this share
/// of the longest edge. Without a limit, collapses cut off half an edge length at the corners of
/// Zalesak's sphere. With a third of the limit, a tenth more faces are left after Enright's test.
constexpr double curved_shift = 0.05;

}  // namespace

Index EdgeCollapser::collapse(Index halfedge) {
  round_enough_ = round_enough;
  // Without a guard, all triangles at vertices of high valence are narrow.
  normal_roundness_ = guard_ != nullptr ? normal_roundness : normal_roundness_for_shape;
  if (!prepare(halfedge)) return no_index;
  met_film_ = false;
  const bool done = roles_[goes_] != roles_[stays_] ? try_bound_end()
                    : shape_.curved                 ? try_curved_positions()
                                                    : try_free_positions();
  if (!done && met_film_) ++films_kept_;
  return done ? stays_ : no_index;
}

Index EdgeCollapser::collapse_to(Index halfedge, const Vec3& position) {
  round_enough_ = round_enough_for_shape;
  normal_roundness_ = normal_roundness_for_shape;
  was_too_long_ = false;
  if (!prepare(halfedge)) return no_index;
  const Vec3 along = mesh_.position(goes_) - mesh_.position(stays_);
  const double share = along.dot(position - mesh_.position(stays_)) / along.squaredNorm();
  return try_position(position, share > 0 ? std::min(share, 1.0) : 0) ? stays_ : no_index;
}

bool EdgeCollapser::prepare(Index halfedge) {
  if (!roles_.may_merge(halfedge) || !mesh_.can_collapse(halfedge)) return false;
  const bool turned = !mesh_.is_border(halfedge) && mesh_.target(halfedge) > mesh_.source(halfedge);
  edge_ = turned ? mesh_.opposite(halfedge) : halfedge;
  goes_ = mesh_.source(edge_);
  stays_ = mesh_.target(edge_);
  gather();
  return true;
}

// Collapses to the end with the higher role (vertex_role.h), which keeps its position.
bool EdgeCollapser::try_bound_end() {
  const bool source_wins = roles_[goes_] > roles_[stays_];
  return try_position(mesh_.position(source_wins ? goes_ : stays_), source_wins ? 1 : 0);
}

void EdgeCollapser::gather() {
  spokes_.clear();
  patch_.clear();
  mean_normal_.setZero();
  volume_ = 0;
  gather_star(goes_);
  gather_star(stays_);
  patch_.vertices.push_back(stays_);
}

void EdgeCollapser::gather_star(Index vertex) {
  const Vec3& corner = mesh_.position(vertex);
  const Vec3& origin = mesh_.position(stays_);
  mesh_.for_each_outgoing(vertex, [&](Index halfedge) {
    const Index first = mesh_.target(halfedge);
    const Index second = mesh_.apex(halfedge);
    const Vec3& a = mesh_.position(first);
    const Vec3& b = mesh_.position(second);
    patch_.replaced.push_back(halfedge / 3);
    const Index other_end = vertex == goes_ ? stays_ : goes_;
    if (first == other_end || second == other_end) return;
    const Vec3 normal = normal_of(corner, a, b);
    const double to_a = (a - corner).squaredNorm();
    const double to_b = (b - corner).squaredNorm();
    const double longest = (guard_ != nullptr ? 1 : stretch_of_stars) * std::max(to_a, to_b);
    const double needed = normal_roundness_ * (to_a + to_b + (b - a).squaredNorm());
    spokes_.push_back({a, b, normal, 12 * normal.squaredNorm() > needed * needed,
                       std::max(longest, longest_to(first)),
                       std::max(longest, longest_to(second))});
    mean_normal_ += normal;
    volume_ += (corner - origin).dot((a - origin).cross(b - origin));
    patch_.vertices.push_back(first);
    patch_.vertices.push_back(second);
    patch_.spokes.push_back(halfedge);
  });
}

/// The largest allowed squared length of an edge from the merged vertex to the neighbor. The size
/// at the merged vertex is the mean of both ends.
double EdgeCollapser::longest_to(Index neighbor) const {
  const double size = 0.5 * (mesh_.mean_size(goes_, stays_) + mesh_.size(neighbor));
  if (!shape_.curved) return longest_ * size * size;
  const double collapsed = (mesh_.position(goes_) - mesh_.position(stays_)).norm();
  const double longest = std::max(std::sqrt(longest_) * size - room_to_stretch * collapsed, 0.0);
  return longest * longest;
}

bool EdgeCollapser::try_free_positions() {
  const Vec3& source = mesh_.position(goes_);
  const Vec3& target = mesh_.position(stays_);
  const Vec3 middle = 0.5 * source + 0.5 * target;
  if (roles_[stays_] == VertexRole::free) {
    const Vec3 shift = volume_keeping_shift(middle);
    if (shift.norm() <= 0.5 * (target - source).norm() && try_position(middle + shift, 0.5)) {
      return true;
    }
  }
  return try_position(middle, 0.5) || try_position(target, 0) || try_position(source, 1);
}

/// Tries both ends and the curved midpoint by increasing squared distance from the planes of the
/// replaced faces. Ties go to the ends, which may still be vertices of the input.
bool EdgeCollapser::try_curved_positions() {
  struct Place {
    Vec3 position;
    double source_share;
    double quadric;
  };
  std::array<Place, 3> places{{{mesh_.position(stays_), 0, 0},
                               {mesh_.position(goes_), 1, 0},
                               {curved_midpoint(mesh_, edge_), 0.5, 0}}};
  for (Place& place : places) place.quadric = shift_to(place.position).quadric;
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.quadric < b.quadric; });
  return std::any_of(places.begin(), places.end(), [&](const Place& place) {
    return try_position(place.position, place.source_share);
  });
}

/// True if the collapse would move the surface farther than ShapeRules::min_film or the limit for
/// curved shapes allows.
bool EdgeCollapser::moves_too_far(const Vec3& position) const {
  const bool has_film = shape_.min_film > 0;
  if (!has_film && !shape_.curved) return false;
  const double limit = has_film
                           ? 0.5 * shape_.min_film
                           : curved_shift * std::sqrt(longest_) * mesh_.mean_size(goes_, stays_);
  return shift_to(position).most > limit;
}

EdgeCollapser::SurfaceShift EdgeCollapser::shift_to(const Vec3& position) const {
  SurfaceShift shift;
  for (const Index face : patch_.replaced) {
    const auto [a, b, c] = mesh_.triangle(face);
    const Vec3 normal = normal_of(a, b, c);
    const double length = normal.norm();
    if (!(length > 0)) continue;
    const double distance = std::abs((position - a).dot(normal)) / length;
    shift.quadric += length * distance * distance;
    shift.most = std::max(shift.most, distance);
  }
  return shift;
}

Vec3 EdgeCollapser::volume_keeping_shift(const Vec3& position) const {
  // Six times the volume is a linear function of the position: position . ring + constant.
  const Vec3& origin = mesh_.position(stays_);
  Vec3 ring = Vec3::Zero();
  for (const Spoke& spoke : spokes_) {
    ring += (spoke.first - origin).cross(spoke.second - origin);
  }
  const double squared = ring.squaredNorm();
  if (squared == 0) return Vec3::Zero();
  return (volume_ - (position - origin).dot(ring)) / squared * ring;
}

bool EdgeCollapser::is_sound(const Vec3& position) {
  double least = 1;
  for (const Spoke& spoke : spokes_) {
    was_too_long_ = (spoke.first - position).squaredNorm() > spoke.first_limit ||
                    (spoke.second - position).squaredNorm() > spoke.second_limit;
    if (was_too_long_) return false;
    const Vec3& before = spoke.has_normal ? spoke.normal : mean_normal_;
    const Vec3 after = normal_of(position, spoke.first, spoke.second);
    if (turns(before, after, least_turn_cosine)) return false;
    least = std::min(least, roundness(position, spoke.first, spoke.second));
  }
  const double share = guard_ != nullptr ? 1 : narrowing_of_stars;
  return least >= round_enough_ || least >= share * least_roundness_before();
}

double EdgeCollapser::least_roundness_before() const {
  double least = 1;
  for (const Index face : patch_.replaced) {
    const auto [a, b, c] = mesh_.triangle(face);
    least = std::min(least, roundness(a, b, c));
  }
  return least;
}

void EdgeCollapser::fill_patch(const Vec3& position) {
  patch_.center = stays_;
  patch_.center_position = position;
  patch_.made.clear();
  patch_.normals.clear();
  patch_.longest_squared = 0;
  for (const Spoke& spoke : spokes_) {
    patch_.longest_squared = std::max(
        {patch_.longest_squared, (spoke.first - position).squaredNorm(),
         (spoke.second - position).squaredNorm(), (spoke.second - spoke.first).squaredNorm()});
    patch_.made.push_back({position, spoke.first, spoke.second});
    patch_.normals.push_back(reliable_normal(position, spoke.first, spoke.second));
  }
}

bool EdgeCollapser::try_position(const Vec3& wanted, double source_share) {
  const Vec3 position = mesh_.rounded(wanted);
  if (!is_sound(position)) return false;
  if (moves_too_far(position)) {
    met_film_ = true;
    return false;
  }
  fill_patch(position);
  if (guard_ != nullptr && !guard_->allows(patch_)) return false;
  if (bound_ != nullptr && !bound_->allows(patch_)) return false;
  mesh_.collapse(edge_, position, source_share);
  if (bound_ != nullptr) bound_->commit(patch_);
  if (guard_ == nullptr) return true;
  guard_->forget(goes_);
  guard_->commit(patch_);
  return true;
}

}  // namespace transformesh
