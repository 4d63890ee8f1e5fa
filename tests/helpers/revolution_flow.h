/// Mean-curvature flow of surfaces of revolution, as the motion of their profile curves in the half
/// plane of the radius r and the height z. This explicit one-dimensional solver shares no code with
/// the library.
///
/// The surface moves along its outward normal n at the speed k - n_r / r. The curvature k of the
/// profile is negative at convex places, which thus recede. A sphere has r(t)^2 = r(0)^2 - 4 t, a
/// cylinder r(t)^2 = r(0)^2 - 2 t. Errors are O(h^2) for points at distance h.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace transformesh::test {

using ProfilePoint = Eigen::Vector2d;  ///< radius and height

/// A profile curve, with the inside of the surface on its left. The curve is closed, or leads from
/// the lower pole to the upper one.
struct Profile {
  std::vector<ProfilePoint> points;
  bool is_closed = false;
};

/// Returns the profile of a torus around the z axis.
inline Profile torus_profile(double major, double minor, int count) {
  Profile profile{{}, true};
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    profile.points.emplace_back(major + minor * std::cos(angle), minor * std::sin(angle));
  }
  return profile;
}

/// Returns the profile of a surface with poles at the heights `low` and `high` and the given radius
/// between them, as `count` points at equal distances.
inline Profile pole_to_pole(double low, double high, int count,
                            const std::function<double(double z)>& radius) {
  constexpr int samples = 100000;
  std::vector<ProfilePoint> fine;
  std::vector<double> lengths{0};
  for (int i = 0; i <= samples; ++i) {
    const double share = (1 - std::cos(std::numbers::pi * i / samples)) / 2;
    const double z = low + (high - low) * share;
    fine.emplace_back(i == 0 || i == samples ? 0 : radius(z), z);
    if (i > 0) lengths.push_back(lengths.back() + (fine[i] - fine[i - 1]).norm());
  }
  Profile profile;
  std::size_t at = 0;
  for (int i = 0; i < count; ++i) {
    const double wanted = lengths.back() * i / (count - 1);
    while (at + 2 < lengths.size() && lengths[at + 1] < wanted) ++at;
    const double share = std::min((wanted - lengths[at]) / (lengths[at + 1] - lengths[at]), 1.0);
    profile.points.push_back((1 - share) * fine[at] + share * fine[at + 1]);
  }
  return profile;
}

inline Profile ellipsoid_profile(double radius, double half_height, int count) {
  return pole_to_pole(-half_height, half_height, count, [=](double z) {
    return radius * std::sqrt(std::max(1 - z * z / (half_height * half_height), 0.0));
  });
}

/// Returns the profile of the shape `dumbbell` of tm-shape: two balls of radius 0.5 around z = -0.7
/// and 0.7, and a neck of radius `neck` between them, blended over 0.2. `neck` is at most 0.3.
inline Profile dumbbell_profile(double neck, int count) {
  constexpr double ball = 0.5, center = 0.7, blend = 0.2;
  const auto distance = [=](double r, double z) {
    const double height = std::abs(z);
    const double to_ball = Eigen::Vector2d(r, height - center).norm() - ball;
    const double to_neck = Eigen::Vector2d(r, std::max(height - center, 0.0)).norm() - neck;
    const double overlap = std::max(blend - std::abs(to_ball - to_neck), 0.0) / blend;
    return std::min(to_ball, to_neck) - overlap * overlap * blend / 4;
  };
  return pole_to_pole(-center - ball, center + ball, count, [=](double z) {
    double low = 0, high = 1;  // bounds of the radius at which `distance` is 0
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (distance(middle, z) < 0 ? low : high) = middle;
    }
    return low;
  });
}

class RevolutionFlow {
 public:
  explicit RevolutionFlow(Profile profile) : profile_(std::move(profile)) {}

  double time() const { return time_; }
  const std::vector<ProfilePoint>& points() const { return profile_.points; }

  /// Advances to a time, which must be before the surface changes its topology.
  void advance_to(double end) {
    while (time_ < end) step(std::min(stable_span(), end - time_));
  }

  /// Area that the profile encloses with the axis.
  double profile_area() const {
    double sum = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      const ProfilePoint &a = profile_.points[i], &b = profile_.points[(i + 1) % size()];
      sum += (a.x() * b.y() - b.x() * a.y()) / 2;
    }
    return sum;
  }

  /// Volume that the surface encloses, as a sum of frustums.
  double volume() const {
    double sum = 0;
    for (std::size_t i = profile_.is_closed ? 0 : 1; i < size(); ++i) {
      const double a = before(i).x(), b = radius(i);
      sum += (a * a + a * b + b * b) / 3 * (profile_.points[i].y() - before(i).y());
    }
    return std::numbers::pi * sum;
  }

  /// Index of the point in the middle of the thinnest neck; the size if there is none.
  std::size_t neck() const {
    std::size_t best = size();
    for (std::size_t i = 1; i + 1 < size(); ++i) {
      const double r = radius(i);
      const bool is_neck = r <= radius(i - 1) && r <= radius(i + 1);
      if (is_neck && (best == size() || r < radius(best))) best = i;
    }
    return best;
  }

  double radius(std::size_t i) const { return profile_.points[i].x(); }

  /// Velocity of each point: along the normal by curvature, along the curve towards equal
  /// distances.
  std::vector<ProfilePoint> velocities() const {
    std::vector<ProfilePoint> result(size());
    for (std::size_t i = 0; i < size(); ++i) result[i] = velocity(i);
    return result;
  }

  void step(double span) {
    const Profile start = profile_;
    move(velocities(), span / 2);
    const std::vector<ProfilePoint> middle = velocities();
    profile_ = start;
    move(middle, span);
    time_ += span;
  }

  /// Returns the time span of a step: a fifth of the squared smallest distance of neighboring
  /// points. Explicit steps are stable up to a quarter of this square.
  double stable_span() const {
    double smallest = 1e300;
    for (std::size_t i = profile_.is_closed ? 0 : 1; i < size(); ++i)
      smallest = std::min(smallest, (profile_.points[i] - before(i)).squaredNorm());
    return smallest / 5;
  }

 private:
  std::size_t size() const { return profile_.points.size(); }
  bool is_pole(std::size_t i) const { return !profile_.is_closed && (i == 0 || i + 1 == size()); }

  /// Return the neighbors of a point. Beyond a pole the curve is mirrored at the axis.
  ProfilePoint before(std::size_t i) const {
    if (profile_.is_closed) return profile_.points[(i + size() - 1) % size()];
    return i > 0 ? profile_.points[i - 1] : mirrored(profile_.points[1]);
  }
  ProfilePoint after(std::size_t i) const {
    if (profile_.is_closed) return profile_.points[(i + 1) % size()];
    return i + 1 < size() ? profile_.points[i + 1] : mirrored(profile_.points[size() - 2]);
  }
  static ProfilePoint mirrored(const ProfilePoint& p) { return {-p.x(), p.y()}; }

  ProfilePoint velocity(std::size_t i) const {
    const ProfilePoint to_next = after(i) - profile_.points[i];
    const ProfilePoint from_last = profile_.points[i] - before(i);
    const double a = from_last.norm(), b = to_next.norm();
    const ProfilePoint bend = 2 / (a + b) * (to_next / b - from_last / a);
    if (is_pole(i)) return {0, 2 * bend.y()};  // both curvatures are equal on the axis
    const ProfilePoint tangent = (a * to_next / b + b * from_last / a).normalized();
    const ProfilePoint normal(tangent.y(), -tangent.x());
    const double speed = bend.dot(normal) - normal.x() / radius(i);
    const double slide = (to_next - from_last).dot(tangent) * 4 / ((a + b) * (a + b));
    return speed * normal + slide * tangent;
  }

  void move(const std::vector<ProfilePoint>& velocities, double span) {
    for (std::size_t i = 0; i < size(); ++i) profile_.points[i] += span * velocities[i];
  }

  Profile profile_;
  double time_ = 0;
};

/// Returns the time at which a torus collapses to a ring. The last part is extrapolated from the
/// collapse of a cylinder.
inline double ring_collapse_time(const Profile& ring) {
  RevolutionFlow flow(ring);
  const double enough = 1e-4 * flow.profile_area();
  while (flow.profile_area() > enough) flow.step(flow.stable_span());
  return flow.time() + flow.profile_area() / (2 * std::numbers::pi);
}

/// Returns the time at which the thinnest neck pinches off. The last part is extrapolated: the
/// square of the radius decreases linearly.
inline double pinch_time(const Profile& dumbbell) {
  RevolutionFlow flow(dumbbell);
  const double enough = 0.1 * flow.radius(flow.neck());
  while (flow.radius(flow.neck()) > enough) flow.step(flow.stable_span());
  const std::size_t neck = flow.neck();
  return flow.time() - flow.radius(neck) / (2 * flow.velocities()[neck].x());
}

}  // namespace transformesh::test
