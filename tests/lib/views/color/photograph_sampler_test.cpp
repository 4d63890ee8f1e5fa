#include "views/color/photograph_sampler.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "helpers/view_maker.h"

using namespace transformesh;

namespace {

const view_maker::Frame frame;
const Vec3 eye(6, 0, 0);
/// Length of a pixel at the surface in front of the camera.
const double pixel = 5 / frame.focal_length;

/// Red grows to the right, green downwards.
Image gradient() {
  Image image(frame.width, frame.height);
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x)
      image.at(x, y) = {static_cast<std::uint8_t>(x / 2), static_cast<std::uint8_t>(y), 50, 255};
  return image;
}

PhotographSampler sampler_of(const Mesh& mesh) {
  return {mesh, view_maker::camera_at(eye, frame), gradient(), pixel};
}

}  // namespace

TEST_CASE("the color of a point is that of the pixel of its projection") {
  const PhotographSampler sampler = sampler_of(test::icosphere(5));
  const PinholeCamera camera = view_maker::camera_at(eye, frame);
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(1, .3, .2), Vec3(1, -.4, .1)}) {
    const Vec3 point = direction.normalized();
    const ViewColor color = sampler.at({point, point, pixel});
    const Vec3 q = camera.projection() * point.homogeneous();
    CHECK(color.quality > 0);
    CHECK(color.color[0] == doctest::Approx(q.x() / q.z() / 2).epsilon(.03));
    CHECK(color.color[1] == doctest::Approx(q.y() / q.z()).epsilon(.03));
    CHECK(color.color[2] == 50);
  }
}

TEST_CASE("quality decreases towards the contour, and is 0 behind it") {
  const PhotographSampler sampler = sampler_of(test::icosphere(5));
  const auto quality = [&](double angle) {
    const Vec3 point(std::cos(angle), std::sin(angle), 0);
    return sampler.at({point, point, pixel}).quality;
  };
  CHECK(quality(0) > quality(.6));
  CHECK(quality(.6) > quality(1.1));
  CHECK(quality(1.5) == 0);
  CHECK(quality(3.1) == 0);
}

TEST_CASE("a hidden point, or one viewed from inside, has no color") {
  const Mesh front = test::moved(test::scaled(test::icosphere(4), .5), {2.5, 0, 0});
  const PhotographSampler sampler = sampler_of(test::joined(test::icosphere(4), front));
  CHECK(sampler.at({Vec3(1, 0, 0), Vec3(1, 0, 0), pixel}).quality == 0);
  CHECK(sampler.at({Vec3(3, 0, 0), Vec3(1, 0, 0), pixel}).quality > 0);
  CHECK(sampler.at({Vec3(3, 0, 0), Vec3(-1, 0, 0), pixel}).quality == 0);
}
