#include "views/photo/disagreement.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/ball_photographs.h"
#include "helpers/random.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "views/cameras/view.h"
#include "views/photo/photo_scene.h"

using namespace transformesh;
using namespace transformesh::test;
using doctest::Approx;

namespace {

constexpr double least_cosine = 0.1;

/// Returns the image with noise of this standard deviation: sums of four uniform numbers.
GrayImage with_noise(GrayImage image, double deviation, unsigned seed) {
  Random random(seed);
  const double half = deviation * std::sqrt(3.0 / 4);
  for (float& intensity : image.pixels) {
    double noise = 0;
    for (int i = 0; i < 4; ++i) noise += random.uniform(-half, half);
    intensity += static_cast<float>(noise);
  }
  return image;
}

PhotoScene noisy_scene(double deviation) {
  std::vector<View> views = ring();
  for (std::size_t v = 0; v < views.size(); ++v)
    views[v].image = with_noise(views[v].image, deviation, static_cast<unsigned>(v + 1));
  return photo_scene(views, 1);
}

}  // namespace

TEST_CASE("noise is measured beside texture, as what the blur of scale 1 leaves of it") {
  GrayImage waves(200, 150);
  for (int y = 0; y < waves.height; ++y)
    for (int x = 0; x < waves.width; ++x)
      waves.at(x, y) = static_cast<float>(128 + 40 * std::sin(0.3 * x + 0.2 * y));
  const GrayImage everywhere(200, 150, 1);
  // Sum the squared weights of a sampled Gaussian with standard deviation 0.6.
  double sum = 0, squares = 0;
  for (int k = -2; k <= 2; ++k) {
    const double weight = std::exp(-k * k / 0.72);
    sum += weight;
    squares += weight * weight;
  }
  const double kept = std::pow(squares / (sum * sum), 2);
  for (const double deviation : {4.0, 12.0}) {
    const GrayImage image = at_scale(with_noise(waves, deviation, 7), 1);
    CHECK(noise_variance(image, everywhere) == Approx(kept * deviation * deviation).epsilon(0.05));
  }
  CHECK(noise_variance(at_scale(waves, 1), everywhere) < 0.1);
  CHECK(noise_variance(waves, GrayImage(200, 150)) == 0);
}

TEST_CASE("noise is measured within a tenth at other scales, too") {
  const GrayImage flat(400, 300, 128);
  for (const double scale : {1.0, std::sqrt(2.0), 2.0, 4.0}) {
    const GrayImage image = at_scale(with_noise(flat, 12, 7), scale);
    const auto count = static_cast<double>(image.pixels.size());
    double sum = 0, squares = 0;
    for (const double intensity : image.pixels) {
      sum += intensity;
      squares += intensity * intensity;
    }
    const double variance = squares / count - sum / count * sum / count;
    const GrayImage everywhere(image.width, image.height, 1);
    CHECK(noise_variance(image, everywhere) == Approx(variance).epsilon(0.1));
  }
}

TEST_CASE("noise explains the disagreement on the true surface, but not on a wrong one") {
  for (const double deviation : {0.0, 10.0, 25.0}) {
    const PhotoScene scene = noisy_scene(deviation);
    const Disagreement right = disagreement(ball(1), scene, least_cosine);
    CHECK(right.all.excess() < 0.06);
    CHECK(disagreement(ball(0.8), scene, least_cosine).all.excess() > 0.4);
    if (deviation > 0)
      CHECK(right.all.mean_floor() >
            1.3 * disagreement(ball(1), noisy_scene(0), least_cosine).all.mean_floor());
  }
}

TEST_CASE("a single view that disagrees does not make a surface doubtful") {
  std::vector<View> views = ring();
  GrayImage other = views[3].image.unpacked();
  std::reverse(other.pixels.begin(), other.pixels.end());
  views[3].image = std::move(other);
  const Disagreement found = disagreement(ball(1), photo_scene(views, 1), least_cosine);
  std::size_t wrong = 0;
  for (const WindowSums& sums : found.of_vertex) wrong += sums.excess() > 0.5 ? 1 : 0;
  CHECK(20 * wrong < found.of_vertex.size());
}

TEST_CASE("vertices that no two views see have no weight; threads change nothing") {
  std::vector<View> views = ring();
  views.resize(2);
  const Mesh mesh = ball(1);
  const PhotoScene scene = photo_scene(views, 1);
  const Disagreement found = disagreement(mesh, scene, least_cosine);
  std::size_t unseen = 0;
  for (const WindowSums& sums : found.of_vertex) unseen += sums.weight == 0 ? 1 : 0;
  CHECK(unseen > mesh.positions.size() / 2);
  CHECK(unseen < mesh.positions.size());
  const ThreadLimit limit(1);
  const Disagreement alone = disagreement(mesh, scene, least_cosine);
  CHECK(alone.all.energy == found.all.energy);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    CHECK(alone.of_vertex[v].energy == found.of_vertex[v].energy);
}
