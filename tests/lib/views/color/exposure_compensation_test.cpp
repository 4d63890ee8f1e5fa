#include "views/color/exposure_compensation.h"

#include <doctest/doctest.h>

#include <random>

using namespace transformesh;

namespace {

std::array<std::uint8_t, 3> intensities(double gray) {
  const auto intensity = static_cast<std::uint8_t>(std::min(gray + 0.5, 255.0));
  return {intensity, intensity, intensity};
}

/// Each place is visible in two neighboring views of a ring. Each view shows it brighter by the
/// view's factor.
std::vector<BestViewColors> places(std::span<const double> factors, double highlights) {
  std::mt19937 random(3);
  std::vector<BestViewColors> seen(4000);
  for (std::size_t p = 0; p < seen.size(); ++p) {
    const double gray = 40 + 120 * static_cast<double>(random() % 1000) / 1000;
    const std::size_t first = p % factors.size();
    const std::size_t second = (p + 1) % factors.size();
    const bool shines = static_cast<double>(random() % 1000) < 1000 * highlights;
    seen[p].add({1, intensities(shines ? 3 * gray : factors[first] * gray)}, first);
    seen[p].add({0.9F, intensities(factors[second] * gray)}, second);
  }
  return seen;
}

}  // namespace

TEST_CASE("gains compensate for brighter and darker photographs") {
  const std::vector<double> factors{1, 0.8, 1.2, 0.9, 1.1, 0.75};
  for (const double highlights : {0.0, 0.1}) {
    const std::vector<Gain> gains =
        compensate_exposure(places(factors, highlights), factors.size());
    const double common = gains[0][0] * factors[0];
    for (std::size_t v = 0; v < factors.size(); ++v)
      for (int channel = 0; channel < 3; ++channel)
        CHECK(gains[v][channel] * factors[v] == doctest::Approx(common).epsilon(0.03));
    CHECK(common == doctest::Approx(1).epsilon(0.15));
    CHECK(largest_gain(gains) > 1.15);
  }
}

TEST_CASE("equal exposures stay equal, and views without overlap have no gain") {
  const std::vector<double> same(5, 1.0);
  for (const Gain& gain : compensate_exposure(places(same, 0), 7))
    CHECK((gain - 1).abs().maxCoeff() < 0.005F);
  CHECK(largest_gain(compensate_exposure({}, 3)) == 1);
  CHECK(compensate_exposure({}, 0).empty());
}
