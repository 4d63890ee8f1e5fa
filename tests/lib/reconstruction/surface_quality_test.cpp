#include "reconstruction/surface_quality.h"

#include <doctest/doctest.h>

using namespace transformesh;

TEST_CASE("a tracked surface is measured by the last one that was made anew") {
  const SurfaceQuality reference{0.2, 0.8, 0.95};
  CHECK(tracking_faults({0.259, 0.721, 0.921}, reference).empty());
  CHECK(tracking_faults({0.27, 0.8, 0.95}, reference) == "dissimilarity");
  CHECK(tracking_faults({0.2, 0.71, 0.91}, reference) == "coverage+silhouettes");
  // A surface that was lost completely has all faults.
  CHECK(tracking_faults({}, reference) == "dissimilarity+coverage+silhouettes");
}

TEST_CASE("of two surfaces fewer faults count first, then the agreement of the photographs") {
  const SurfaceQuality reference{0.2, 0.8, 0.95};
  const SurfaceQuality crumpled{0.19, 0.5, 0.95};
  const SurfaceQuality good{0.25, 0.8, 0.95};
  CHECK(is_better(good, crumpled, reference));
  CHECK_FALSE(is_better(crumpled, good, reference));
  CHECK(is_better({0.3, 0.8, 0.95}, {0.31, 0.8, 0.95}, reference));
  CHECK_FALSE(is_better({0.31, 0.8, 0.95}, {0.31, 0.8, 0.95}, reference));
}
