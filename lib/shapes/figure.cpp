#include "shapes/figure.h"

#include <algorithm>
#include <numbers>

#include "shapes/implicit.h"
#include "support/elementary/trigonometric.h"

namespace transformesh::shapes {
namespace {

constexpr double limb = 0.09;           // radius of arms and shins
constexpr double thigh = 0.115;         // radius of a thigh
constexpr double upper_arm = 0.42;      ///< length of an upper arm
constexpr double forearm = 0.58;        ///< length of a forearm
constexpr double reach = 0.05;          // largest gap between forearms that is bridged
constexpr double bridge_radius = 0.06;  // radius of the bridge between forearms
constexpr double blend = 0.08;          // width of the blend between limbs

/// A bone. x points to the figure's left, y up, z forward.
struct Bone {
  Vec3 begin, end;

  Vec3 at(double share) const { return begin + share * (end - begin); }

  double distance(const Vec3& point) const {
    const Vec3 along = end - begin;
    return (point - at(std::clamp((point - begin).dot(along) / along.squaredNorm(), 0.0, 1.0)))
        .norm();
  }

  /// Ternary search: the distance from a point that moves along a bone to another bone is convex.
  double distance(const Bone& other) const {
    double low = 0;
    double high = 1;
    for (int i = 0; i < 100; ++i) {
      const double third = (high - low) / 3;
      const bool is_first_nearer =
          other.distance(at(low + third)) < other.distance(at(high - third));
      (is_first_nearer ? high : low) = is_first_nearer ? high - third : low + third;
    }
    return other.distance(at(low));
  }
};

struct Arm {
  Bone upper, fore;

  double gap(const Arm& other) const { return fore.distance(other.fore) - 2 * limb; }
};

/// Directions of an arm's bones; x points away from the body.
struct Pose {
  Vec3 upper, fore;
};

/// Returns an arm. The left arm (side 1) passes in front of the right one (side -1).
Arm arm_at(double time, double side) {
  const Pose ahead{{0.6, -0.66, 0.45}, {-0.3, 0.15, 0.95}};
  const Pose raised{{0.62, -0.5, 0.6}, {-0.2, 0.7, 0.7}};
  const Pose crossed{{0.32, -0.66, 0.69}, {-0.85, 0.38 + 0.05 * side, 0.4 + 0.15 * side}};
  const Pose& open = time < 0.5 ? ahead : raised;
  const double wave = elementary::sin(std::numbers::pi * time);
  const auto direction = [&](const Vec3& from, const Vec3& to) {
    const Vec3 turned = (from + wave * wave * (to - from)).normalized();
    return Vec3(side * turned.x(), turned.y(), turned.z());
  };
  const Vec3 shoulder(side * 0.27, 0.4, 0);
  const Vec3 elbow = shoulder + upper_arm * direction(open.upper, crossed.upper);
  return {{shoulder, elbow}, {elbow, elbow + forearm * direction(open.fore, crossed.fore)}};
}

double trunk(const Vec3& point) {
  const double chest = Bone{{0, -0.15, 0}, {0, 0.3, 0}}.distance(point) - 0.2;
  const double shoulders = Bone{{-0.27, 0.4, 0}, {0.27, 0.4, 0}}.distance(point) - limb;
  const double neck = Bone{{0, 0.4, 0}, {0, 0.7, 0}}.distance(point) - 0.08;
  const double head = (point - Vec3(0, 0.82, 0.02)).norm() - 0.2;
  return smooth_minimum(smooth_minimum(chest, shoulders, 2 * blend),
                        smooth_minimum(neck, head, blend), blend);
}

double leg(const Vec3& point, double side) {
  const Vec3 knee(side * 0.18, -0.62, 0.04);
  const Vec3 ankle(side * 0.2, -1.05, -0.02);
  const double upper = Bone{{side * 0.12, -0.2, 0}, knee}.distance(point) - thigh;
  const double shin = Bone{knee, ankle}.distance(point) - limb;
  const double foot = Bone{ankle, {side * 0.24, -1.07, 0.18}}.distance(point) - 0.08;
  return smooth_minimum(upper, smooth_minimum(shin, foot, blend / 2), blend / 2);
}

double arms(const Vec3& point, const Arm& left, const Arm& right, double bridge) {
  const double left_fore = left.fore.distance(point) - limb;
  const double right_fore = right.fore.distance(point) - limb;
  const double forearms =
      bridge > 0 ? smooth_minimum(left_fore, right_fore, bridge) : std::min(left_fore, right_fore);
  const double upper_arms = std::min(left.upper.distance(point), right.upper.distance(point));
  return smooth_minimum(upper_arms - limb, forearms, blend);
}

/// Returns the width of smooth blending that joins two tubes with this gap by a bridge of
/// `bridge_radius`; 0 if the tubes stay separate. `limb` is the radius of the tubes. A point at
/// distance s from the middle of the gap is gap / 2 + s^2 / (2 limb) away from both tubes. Blending
/// subtracts a quarter of the width from this distance.
double bridge_width(double gap) {
  if (gap >= reach) return 0;
  return 2 * (std::max(gap, 0.0) + bridge_radius * bridge_radius / limb);
}

}  // namespace

Mesh figure(double time, std::size_t faces, const Progress& progress) {
  const Arm left = arm_at(time, 1);
  const Arm right = arm_at(time, -1);
  const double bridge = bridge_width(left.gap(right));
  ImplicitSolid solid;
  solid.function = [&](const Vec3& point) {
    const double legs = std::min(leg(point, 1), leg(point, -1));
    return smooth_minimum(smooth_minimum(trunk(point), legs, blend),
                          arms(point, left, right, bridge), blend);
  };
  solid.genus = bridge > 0 ? 1 : 0;
  return mesh_implicit(solid, faces, progress);
}

}  // namespace transformesh::shapes
