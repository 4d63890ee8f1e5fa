#include "picture/soft_shadow.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/local_measures.h"
#include "raster/camera.h"
#include "raster/rasterize.h"
#include "support/elementary/trigonometric.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Positions on the lamp; more make smoother shadows and take more time.
constexpr int places = 48;
constexpr int depth_image_side = 512;  ///< width and height of the depth images in pixels
constexpr double distance = 500;       ///< distance of the lamp, in radii of the mesh
/// Tangent of half the angle of the disc, 4 degrees.
constexpr double tangent = 0.069926811943510415;
/// Least and largest distance by which points are lifted off the surface, in pixels of the depth
/// images.
constexpr double least_lift = 0.5, most_lift = 2;

struct Ball {
  Vec3 middle = Vec3::Zero();
  double radius = 1;
};

Ball ball_around(const Mesh& mesh) {
  const std::vector<Vec3> points = used_positions(mesh);
  if (points.empty()) return {};
  Vec3 low = points[0], high = points[0];
  for (const Vec3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  Ball ball{low / 2 + high / 2, 0};
  for (const Vec3& point : points)
    ball.radius = std::max(ball.radius, (point - ball.middle).stableNorm());
  if (!(ball.radius > 0)) ball.radius = 1;
  return ball;
}

/// Returns one of evenly distributed points on the unit disc: equal steps of area, rotated by the
/// golden angle.
Eigen::Vector2d place_on_disc(int i) {
  const double radius = std::sqrt((i + 0.5) / places);
  const double turn = 2 * std::numbers::pi * std::fmod(i / std::numbers::phi, 1.0);
  return {radius * elementary::cos(turn), radius * elementary::sin(turn)};
}

/// Returns a camera whose image contains the ball, with one pixel to spare at the border.
Camera camera_at(const Vec3& eye, const Ball& ball) {
  const Vec3 forward = (ball.middle - eye).normalized();
  const Vec3 right = forward.unitOrthogonal();
  const Vec3 down = forward.cross(right);
  const double away = (ball.middle - eye).norm() / ball.radius;
  const double focal = (depth_image_side / 2.0 - 1) * std::sqrt(away * away - 1);
  constexpr double middle = (depth_image_side - 1) / 2.0;  // center of the image in pixels
  Camera camera;
  camera.width = camera.height = depth_image_side;
  camera.projection.row(0).head<3>() = focal * right + middle * forward;
  camera.projection.row(1).head<3>() = focal * down + middle * forward;
  camera.projection.row(2).head<3>() = forward;
  camera.projection.col(3) = -camera.projection.leftCols<3>() * eye;
  return camera;
}

Raster<float> depths_of(const FaceBuffer& seen) {
  Raster<float> depths(seen.width, seen.height, std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < seen.pixels.size(); ++i)
    if (seen.pixels[i].face != no_index) depths.pixels[i] = seen.pixels[i].depth;
  return depths;
}

}  // namespace

SoftShadow::SoftShadow(const Mesh& mesh, const Vec3& towards_lamp) : towards_lamp_(towards_lamp) {
  const Ball ball = ball_around(mesh);
  pixel_ = 2 * ball.radius / depth_image_side;
  const double away = distance * ball.radius;
  const Vec3 across = towards_lamp.unitOrthogonal();
  const Vec3 along = towards_lamp.cross(across);
  for (int i = 0; i < places; ++i) {
    const Eigen::Vector2d place = tangent * place_on_disc(i);
    const Vec3 direction = towards_lamp + place.x() * across + place.y() * along;
    const Camera camera = camera_at(ball.middle + away * direction, ball);
    places_.push_back({camera, depths_of(rasterize(mesh, camera))});
  }
}

/// Interpolates the results of the depth tests of four pixels. Points outside of the image are lit.
float SoftShadow::share_in_front(const Place& place, const Vec3& point) {
  const Vec3 seen = place.camera.project(point);
  const double x = seen.x() / seen.z(), y = seen.y() / seen.z();
  if (!(x >= 0 && y >= 0 && x < depth_image_side - 1 && y < depth_image_side - 1)) return 1;
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  const auto right = static_cast<float>(x - column), below = static_cast<float>(y - row);
  const auto depth = static_cast<float>(seen.z());
  const auto is_lit = [&](int i, int j) {
    return depth <= place.depths.at(column + i, row + j) ? 1.0F : 0.0F;
  };
  return (1 - below) * ((1 - right) * is_lit(0, 0) + right * is_lit(1, 0)) +
         below * ((1 - right) * is_lit(0, 1) + right * is_lit(1, 1));
}

float SoftShadow::share_seen(const Vec3& point, const Vec3& normal) const {
  const double facing = normal.dot(towards_lamp_);
  const double slope = std::sqrt(std::max(0.0, 1 - facing * facing));
  const Vec3 lifted = point + pixel_ * (least_lift + (most_lift - least_lift) * slope) * normal;
  float sum = 0;
  for (const Place& place : places_) sum += share_in_front(place, lifted);
  return sum / places;
}

Vec3 round_place(const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>& normals,
                 double weight_0, double weight_1) {
  const std::array weights{weight_0, weight_1, 1 - weight_0 - weight_1};
  const Vec3 point = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
  Vec3 place = point;
  for (std::size_t i = 0; i < 3; ++i) {
    // Distance below the tangent plane at the corner.
    const double below = std::max(0.0, (corners[i] - point).dot(normals[i]));
    place += weights[i] * below * normals[i];
  }
  return place;
}

}  // namespace transformesh
