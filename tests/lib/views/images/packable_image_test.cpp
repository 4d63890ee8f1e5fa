#include "views/images/packable_image.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "helpers/photographed.h"
#include "transformesh/photo_step.h"
#include "transformesh/shapes.h"
#include "views/cameras/view.h"
#include "views/photo/photo_scene.h"
#include "views/photo/scene_step.h"
#include "views/photo/visible_surface.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

GrayImage ramp(float start, float step) {
  GrayImage image(30, 20);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = start + step * static_cast<float>(i);
  return image;
}

PackableImage packed(const GrayImage& image,
                     PackableImage::Kind kind = PackableImage::Kind::intensities) {
  PackableImage held = image;
  held.pack(kind);
  CHECK(held.is_packed());
  return held;
}

/// Returns the largest difference.
float difference(const GrayImage& first, const PackableImage& second) {
  const GrayImage other = second;
  float most = 0;
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    most = std::max(most, std::abs(first.pixels[i] - other.pixels[i]));
    const int x = static_cast<int>(i % 30);
    CHECK(second.at(x, static_cast<int>(i / 30)) == other.pixels[i]);
  }
  return most;
}

void check_part(const PackableImage& held) {
  const PackableImage part = held.cropped(3, 4, 10, 5);
  GrayImage unpacked;
  held.unpack_rectangle(3, 4, 10, 5, unpacked);
  CHECK(part.width == 10);
  CHECK(part.height == 5);
  CHECK(part.is_packed() == held.is_packed());
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 10; ++x) {
      CHECK(part.at(x, y) == held.at(x + 3, y + 4));
      CHECK(unpacked.at(x, y) == held.at(x + 3, y + 4));
    }
  }
}

}  // namespace

TEST_CASE("whole intensities take a byte and stay; others take two and are rounded") {
  const GrayImage whole = ramp(0, 1);
  GrayImage bytes = whole;
  for (float& intensity : bytes.pixels) intensity = std::fmod(intensity, 256.0F);
  CHECK(packed(bytes).size() == bytes.pixels.size());
  CHECK(difference(bytes, packed(bytes)) == 0);
  const GrayImage fine = ramp(0.1F, 0.37F);
  CHECK(packed(fine).size() == 2 * fine.pixels.size());
  CHECK(difference(fine, packed(fine)) <= 1.0F / 512);
}

TEST_CASE("masks take a bit a pixel") {
  GrayImage mask = ramp(0, 0);
  for (std::size_t i = 0; i < mask.pixels.size(); ++i)
    if (i * i % 7 < 3) mask.pixels[i] = 255;
  CHECK(packed(mask).size() == (mask.pixels.size() + 7) / 8);
  CHECK(difference(mask, packed(mask)) == 0);
  mask.at(3, 4) = 254;
  CHECK(packed(mask).size() == mask.pixels.size());
  CHECK(difference(mask, packed(mask)) == 0);
}

TEST_CASE("the largest of four pixels, packed or not") {
  GrayImage depths = ramp(5, 0.3F);
  for (std::size_t i = 0; i < depths.pixels.size(); i += 3) depths.pixels[i] = 0;
  const PackableImage plain = depths;
  const PackableImage held = packed(depths, PackableImage::Kind::depths);
  PackableImage room;
  for (const PackableImage* const image : {&plain, &held.opened(room)})
    for (int y = 0; y + 1 < 20; ++y)
      for (int x = 0; x + 1 < 30; ++x)
        CHECK(image->largest_of_four(x, y) ==
              std::max({image->at(x, y), image->at(x + 1, y), image->at(x, y + 1),
                        image->at(x + 1, y + 1)}));
}

TEST_CASE("distances keep their sign, and those without a contour are infinite") {
  const auto kind = PackableImage::Kind::distances;
  CHECK(difference(ramp(-300, 1.01F), packed(ramp(-300, 1.01F), kind)) <= 1.0F / 128);
  GrayImage extreme = ramp(-infinity, 0);
  extreme.at(1, 0) = infinity;
  extreme.at(2, 0) = -10000;
  extreme.at(3, 0) = 10000;
  const PackableImage held = packed(extreme, kind);
  const PackableImage& constant = held;
  CHECK(constant.at(0, 0) == -infinity);
  CHECK(constant.at(1, 0) == infinity);
  CHECK(constant.at(2, 0) < -511);
  CHECK(constant.at(3, 0) > 511);
}

TEST_CASE("packed depths are never nearer than before, and 0 means none") {
  GrayImage depths = ramp(500, 0.3F);
  depths.at(5, 5) = 0;
  const PackableImage held = packed(depths, PackableImage::Kind::depths);
  CHECK(difference(depths, held) < 0.01F);
  const GrayImage again = held;
  for (std::size_t i = 0; i < depths.pixels.size(); ++i)
    CHECK(again.pixels[i] >= depths.pixels[i] * (1 - 1e-6F));
  const PackableImage& constant = held;
  CHECK(constant.at(5, 5) == 0);
  const PackableImage flat = packed(ramp(7, 0), PackableImage::Kind::depths);
  CHECK(difference(ramp(7, 0), flat) == 0);
}

TEST_CASE("a part of an image, packed or not") {
  const GrayImage image = ramp(0.5F, 0.25F);
  for (const bool is_packed : {false, true}) {
    PackableImage held = image;
    if (is_packed) held.pack();
    check_part(held);
  }
  PackableImage distances = image;
  distances.pack(PackableImage::Kind::distances);
  check_part(distances);
  GrayImage mask = image;
  for (float& intensity : mask.pixels) intensity = std::fmod(intensity, 2.0F) < 1 ? 0.0F : 255.0F;
  check_part(packed(mask));
}

TEST_CASE("a step by packed photographs is nearly that by floats") {
  const Mesh ball = make_sphere(Vec3::Zero(), 0.9, 2000);
  std::vector<View> views = photographed(make_sphere(Vec3::Zero(), 1, 2000));
  const PhotoScene plain = photo_scene(views, 1);
  for (View& view : views) view.image.pack(), view.silhouette.pack();
  const PhotoScene small = photo_scene(views, 1);
  CHECK(small.views[0].image.is_packed());
  CHECK(small.distances[0].is_packed());
  Mesh first = ball;
  Mesh second = ball;
  const PhotoStepResult one = photo_step(first, plain);
  const PhotoStepResult two = photo_step(second, small);
  CHECK(two.dissimilarity == doctest::Approx(one.dissimilarity).epsilon(0.001));
  double most = 0;
  double moved = 0;
  for (std::size_t v = 0; v < ball.positions.size(); ++v) {
    most = std::max(most, (first.positions[v] - second.positions[v]).norm());
    moved = std::max(moved, (first.positions[v] - ball.positions[v]).norm());
  }
  CHECK(moved > 0.005);
  CHECK(most < 0.02 * moved);
}

TEST_CASE(
    "an image of bytes is blurred when it is read, to the intensities of one blurred before") {
  for (const auto& [width, height] : {std::pair(30, 20), std::pair(2, 2), std::pair(3, 7)}) {
    GrayImage bytes(width, height);
    for (std::size_t i = 0; i < bytes.pixels.size(); ++i)
      bytes.pixels[i] = static_cast<float>(i * i * 37 % 256);
    const PackableImage blurred = packed(at_scale(bytes, 1));
    View view{"", PinholeCamera(), bytes, {}};
    view.image.pack();
    const PackableImage held = at_scale(view, 1).image;
    CHECK(held.size() == bytes.pixels.size());
    int different = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) different += held.at(x, y) != blurred.at(x, y);
    CHECK(different == 0);
    for (const auto& [x, y] :
         {std::pair(0, 0), std::pair(1, 1), std::pair(width - 1, height - 1)}) {
      GrayImage part, expected;
      held.unpack_rectangle(x, y, width - x, height - y, part);
      blurred.unpack_rectangle(x, y, width - x, height - y, expected);
      CHECK(part.pixels == expected.pixels);
    }
    const PackableImage cropped = held.cropped(1, 0, width - 1, height - 1);
    CHECK(GrayImage(cropped).pixels ==
          GrayImage(blurred.cropped(1, 0, width - 1, height - 1)).pixels);
  }
}

TEST_CASE("packed photographs and what is found in them take less than 8 bytes a pixel") {
  const Mesh ball = make_sphere(Vec3::Zero(), 1, 2000);
  std::vector<View> views = photographed(ball);
  double pixels = 0;
  double held = 0;
  for (View& view : views) {
    view.image.pack(), view.silhouette.pack();
    pixels += view.image.width * view.image.height;
    held += static_cast<double>(view.image.size() + view.silhouette.size());
  }
  CHECK(held < 1.2 * pixels);

  const PhotoScene scene = take_photo_scene(views, 1);
  for (const View& view : views) CHECK(view.image.size() + view.silhouette.size() == 0);
  const SeenViews seen(ball, scene.views, 0.1);
  held = 0;
  for (std::size_t v = 0; v < views.size(); ++v)
    held += static_cast<double>(scene.views[v].image.size() + scene.views[v].silhouette.size() +
                                scene.distances[v].size() + seen.depths(v).size());
  CHECK(held < 4 * pixels);
}

TEST_CASE("a cropped view shows points at its own pixels") {
  const std::vector<View> views = photographed(make_sphere(Vec3::Zero(), 1, 500), small_ring(3));
  const View part = cropped(views[0], 10, 7, 60, 50);
  const Vec3 point(0.2, 0.1, 0.3);
  const Vec3 whole = views[0].camera.projection() * point.homogeneous();
  const Vec3 q = part.camera.projection() * point.homogeneous();
  CHECK(q.x() / q.z() == doctest::Approx(whole.x() / whole.z() - 10));
  CHECK(q.y() / q.z() == doctest::Approx(whole.y() / whole.z() - 7));
  CHECK(part.image.at(5, 5) == views[0].image.at(15, 12));
}
