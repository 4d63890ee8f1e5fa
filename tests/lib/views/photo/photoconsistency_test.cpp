#include "views/photo/photoconsistency.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "helpers/intensities.h"
#include "helpers/random.h"
#include "raster/rasterize.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "views/cameras/view.h"

using namespace transformesh;
using doctest::Approx;

namespace {

constexpr int width = 200;
constexpr int height = 160;
constexpr double focal = 260;
constexpr double distance = 2;
constexpr int grid = 64;
/// Half side of the patch, which extends beyond both fields of view.
constexpr double half_side = 1.6;

/// A solid texture: 60 waves of lengths 0.12 to 0.8.
class Texture {
 public:
  Texture() {
    test::Random random(11);
    for (int i = 0; i < 60; ++i) {
      const double length = 0.12 * std::pow(0.8 / 0.12, random.uniform(0, 1));
      waves_.push_back(random.point(-1, 1).normalized() * (2 * std::numbers::pi / length));
      phases_.push_back(random.uniform(0, 2 * std::numbers::pi));
    }
  }
  float intensity(const Vec3& point) const {
    double sum = 0;
    for (std::size_t i = 0; i < waves_.size(); ++i)
      sum += std::sin(waves_[i].dot(point) + phases_[i]);
    return static_cast<float>(128 + 9 * sum);
  }

 private:
  std::vector<Vec3> waves_;
  std::vector<double> phases_;
};

/// A square patch at z = 0 that faces +z.
Mesh patch() {
  Mesh mesh;
  for (int i = 0; i <= grid; ++i) {
    for (int j = 0; j <= grid; ++j)
      mesh.positions.emplace_back(half_side * (2.0 * i / grid - 1),
                                  half_side * (2.0 * j / grid - 1), 0);
  }
  for (Index i = 0; i < grid; ++i) {
    for (Index j = 0; j < grid; ++j) {
      const Index a = i * (grid + 1) + j;
      const Index b = a + grid + 1;
      mesh.faces.push_back({a, b, b + 1});
      mesh.faces.push_back({a, b + 1, a + 1});
    }
  }
  return mesh;
}

/// Returns a camera that points at the origin from +z, rotated about y.
PinholeCamera camera(double angle_deg) {
  PinholeCamera result;
  result.intrinsics << focal, 0, (width - 1) / 2.0, 0, focal, (height - 1) / 2.0, 0, 0, 1;
  const double angle = angle_deg * std::numbers::pi / 180;
  result.rotation = Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitX()).toRotationMatrix() *
                    Eigen::AngleAxisd(-angle, Vec3::UnitY()).toRotationMatrix();
  result.translation = {0, 0, distance};
  return result;
}

/// Returns a photograph of the flat patch.
View photograph(const PinholeCamera& camera) {
  const Texture texture;
  View view{"", camera, GrayImage(width, height), {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec3 ray = camera.ray(x, y);
      const double depth = -camera.center().z() / ray.z();
      view.image.at(x, y) = texture.intensity(camera.center() + depth * ray);
    }
  }
  view.image = at_scale(view.image, 1);
  return view;
}

struct Scene {
  std::vector<View> views{photograph(camera(-10)), photograph(camera(10))};
  std::vector<ViewPair> pairs{{0, 1}, {1, 0}};
  Mesh mesh = patch();
  PhotoconsistencyOptions options;

  Scene() {
    options.correlation.contrast = 0;  // rho is constant in the derivative
    test::Random random(3);
    for (Vec3& p : mesh.positions)
      p.z() = 0.03 * std::sin(5 * p.x() + 1) * std::cos(4 * p.y()) + random.uniform(-0.004, 0.004);
  }
  Photoconsistency measure() const {
    return photoconsistency(mesh, views, SeenViews(mesh, views, 0.1), pairs, options);
  }
  double loss_moved(std::span<const Vec3> field, double factor) const {
    Scene moved(*this);
    for (std::size_t v = 0; v < field.size(); ++v) moved.mesh.positions[v] += factor * field[v];
    return moved.measure().loss;
  }
  double difference_quotient(std::span<const Vec3> field, double step) const {
    return (loss_moved(field, step) - loss_moved(field, -step)) / (2 * step);
  }
};

std::vector<Vec3> bump(const Mesh& mesh, const Vec3& center, const Vec3& direction) {
  std::vector<Vec3> field;
  for (const Vec3& p : mesh.positions)
    field.push_back(direction * std::exp(-(p - center).squaredNorm() / (2 * 0.15 * 0.15)));
  return field;
}

/// Derivatives compared with difference quotients. Errors are relative to the usual size of the
/// quotients.
class Comparison {
 public:
  void add(double derivative, double quotient) {
    derivatives_.push_back(derivative);
    quotients_.push_back(quotient);
  }
  double slope() const { return dot(derivatives_, quotients_) / dot(quotients_, quotients_); }
  double correlation() const {
    return dot(derivatives_, quotients_) /
           std::sqrt(dot(quotients_, quotients_) * dot(derivatives_, derivatives_));
  }
  double largest_error() const {
    const double usual =
        std::sqrt(dot(quotients_, quotients_) / static_cast<double>(quotients_.size()));
    double largest = 0;
    for (std::size_t i = 0; i < quotients_.size(); ++i)
      largest = std::max(largest, std::abs(derivatives_[i] - quotients_[i]) / usual);
    return largest;
  }

 private:
  static double dot(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  }
  std::vector<double> derivatives_;
  std::vector<double> quotients_;
};

/// A square between the cameras and the middle of the patch.
Mesh floating_square() {
  Mesh mesh;
  mesh.positions = {{-0.1, -0.1, 0.4}, {0.1, -0.1, 0.4}, {0.1, 0.1, 0.4}, {-0.1, 0.1, 0.4}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

double product(std::span<const Vec3> a, std::span<const Vec3> b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += a[v].dot(b[v]);
  return sum;
}

}  // namespace

TEST_CASE("the derivative is that of the energy: bumps inside both images") {
  // Quotients are accurate to a thousandth of the usual derivative, because images and sums are
  // floats, and bilinear intensities have kinks. This test would find the error of 4 % by rounding
  // to a gradient image. It would also find the error of 36 % if the terms of the windows' means
  // and variances were missing.
  for (const Interpolation kind : {Interpolation::catmull_rom, Interpolation::bilinear}) {
    Scene scene;
    scene.options.interpolation = kind;
    const Photoconsistency at = scene.measure();
    test::Random random(5);
    Comparison found;
    for (int i = 0; i < 12; ++i) {
      const Vec3 center(random.uniform(-0.25, 0.25), random.uniform(-0.2, 0.2), 0);
      const Vec3 direction = Vec3(0, 0, 1) + random.point(-0.7, 0.7);
      const auto field = bump(scene.mesh, center, direction);
      found.add(product(at.gradient, field), scene.difference_quotient(field, 5e-4));
    }
    CHECK(found.slope() == Approx(1).epsilon(0.001));
    CHECK(found.largest_error() < 0.005);
    CHECK(found.correlation() > 0.99999);
  }
}

TEST_CASE("with a robust loss the derivative is that of the loss, and not that of the energy") {
  Scene scene;
  const Photoconsistency plain = scene.measure();
  for (const double robust : {0.03, 0.3}) {
    scene.options.correlation.robust = robust;
    const Photoconsistency at = scene.measure();
    CHECK(at.energy == plain.energy);
    CHECK(at.loss < at.energy);
    test::Random random(7);
    Comparison found;
    Comparison mistaken;
    for (int i = 0; i < 12; ++i) {
      const Vec3 center(random.uniform(-0.25, 0.25), random.uniform(-0.2, 0.2), 0);
      const auto field = bump(scene.mesh, center, Vec3(0, 0, 1) + random.point(-0.7, 0.7));
      const double quotient = scene.difference_quotient(field, 5e-4);
      found.add(product(at.gradient, field), quotient);
      mistaken.add(product(plain.gradient, field), quotient);
    }
    CHECK(found.slope() == Approx(1).epsilon(0.001));
    CHECK(found.largest_error() < 0.005);
    CHECK(found.correlation() > 0.99999);
    CHECK(mistaken.slope() > 1.2);
    CHECK(mistaken.correlation() < 0.999);
  }
}

TEST_CASE("the derivative is that of the energy: single vertices in any direction") {
  const Scene scene;
  const Photoconsistency at = scene.measure();
  test::Random random(6);
  Comparison found;
  for (int i = 0; i < 40; ++i) {
    const std::size_t v = (20 + random.below(24)) * (grid + 1) + 20 + random.below(24);
    std::vector<Vec3> field(scene.mesh.positions.size(), Vec3::Zero());
    field[v] = Vec3(0, 0, 1) + random.point(-0.5, 0.5);
    found.add(product(at.gradient, field), scene.difference_quotient(field, 3e-4));
  }
  CHECK(found.slope() == Approx(1).epsilon(0.002));
  CHECK(found.correlation() > 0.999);
}

TEST_CASE("the derivative leaves out what borders and contours add") {
  // Pixels appear and vanish where the border of an image cuts the bump.
  const Scene scene;
  const auto at_border = bump(scene.mesh, Vec3(-0.73, 0, 0), Vec3(0, 0, 1));
  const double exact = product(scene.measure().gradient, at_border);
  CHECK(std::abs(exact / scene.difference_quotient(at_border, 5e-4) - 1) > 0.5);

  // The same happens where a contour moves over the patch.
  Scene shaded;
  const Mesh small = floating_square();
  const Index first = static_cast<Index>(shaded.mesh.positions.size());
  shaded.mesh.positions.insert(shaded.mesh.positions.end(), small.positions.begin(),
                               small.positions.end());
  for (Face face : small.faces) {
    for (Index& v : face) v += first;
    shaded.mesh.faces.push_back(face);
  }
  std::vector<Vec3> field(shaded.mesh.positions.size(), Vec3::Zero());
  for (std::size_t v = first; v < field.size(); ++v) field[v] = Vec3(1, 0, 0);
  const double by_gradient = product(shaded.measure().gradient, field);
  CHECK(std::abs(by_gradient / shaded.difference_quotient(field, 5e-3) - 1) > 0.5);
}

TEST_CASE("the true surface is consistent, also under a change of light") {
  Scene scene;
  scene.options.correlation.noise_variance = 0.01;  // small, because noise counts as inconsistent
  for (Vec3& p : scene.mesh.positions) p.z() = 0;
  const Photoconsistency exact = scene.measure();
  CHECK(exact.energy / exact.weight < 2e-3);
  CHECK(exact.weight == exact.pixels);
  test::change_intensities(scene.views[1].image,
                           [](float intensity) { return 1.3F * intensity - 40; });
  CHECK(scene.measure().energy / exact.weight < 4e-3);

  // At half a pixel of parallax the energy is larger, and the gradient leads back.
  for (Vec3& p : scene.mesh.positions) p.z() = 0.02;
  const Photoconsistency off = scene.measure();
  CHECK(off.energy > 10 * exact.energy);
  Vec3 sum = Vec3::Zero();
  for (const Vec3& g : off.gradient) sum += g;
  CHECK(sum.z() > 0);
}

TEST_CASE("hidden points are not compared") {
  Scene scene;
  const Photoconsistency open = scene.measure();
  // A wall that the first camera sees edge-on, and that hides half of the patch from the second.
  Scene walled;
  const Vec3 eye = walled.views[0].camera.center();
  const Index first = static_cast<Index>(walled.mesh.positions.size());
  for (const double y : {-2.0, 2.0}) {
    walled.mesh.positions.emplace_back(0.0, y, 0.1);
    walled.mesh.positions.push_back(0.5 * (eye + Vec3(0, 0, 0.1)) + Vec3(0, 0.5 * y, 0));
  }
  for (const Face face : {Face{0, 1, 2}, Face{1, 3, 2}, Face{0, 2, 1}, Face{1, 2, 3}})
    walled.mesh.faces.push_back({first + face[0], first + face[1], first + face[2]});
  const double share =
      static_cast<double>(walled.measure().pixels) / static_cast<double>(open.pixels);
  CHECK(share > 0.2);
  CHECK(share < 0.9);
}

TEST_CASE("the same bytes for any number of threads, and pairs add up") {
  const Scene scene;
  const Photoconsistency many = scene.measure();
  const ThreadLimit limit(1);
  const Photoconsistency one = scene.measure();
  CHECK(many.energy == one.energy);
  CHECK(many.gradient == one.gradient);
  CHECK(many.curvature == one.curvature);
  Scene half;
  half.pairs = {{0, 1}};
  const Photoconsistency forth = half.measure();
  half.pairs = {{1, 0}};
  const Photoconsistency back = half.measure();
  CHECK(forth.energy + back.energy == Approx(one.energy).epsilon(1e-12));
  CHECK(forth.pixels + back.pixels == one.pixels);
  half.pairs = {{0, 2}};
  CHECK_THROWS_AS(half.measure(), UsageError);
}
