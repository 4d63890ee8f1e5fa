#include "reconstruction/start_comparison.h"

#include <doctest/doctest.h>

using namespace transformesh;

namespace {

SurfaceMeasures measures(double dissimilarity, double disagreement,
                         std::vector<double> outlines = {}) {
  SurfaceMeasures result;
  result.windows.dissimilarity = dissimilarity;
  result.doubt.disagreement = disagreement;
  result.outlines = std::move(outlines);
  return result;
}

}  // namespace

TEST_CASE("a start stays unless photographs or outlines agree clearly better") {
  const SurfaceMeasures start = measures(0.2, 0.1, {0.99, 0.98});
  CHECK(reason_to_keep(start, measures(0.19, 0.079, {0.99, 0.98})).empty());
  CHECK(reason_to_keep(start, measures(0.19, 0.081, {0.99, 0.98})) ==
        "photographs do not agree clearly better on the result than on the initial mesh");
  CHECK(reason_to_keep(start, measures(0.19, 0.081, {0.995, 0.981})).empty());
  CHECK(reason_to_keep(measures(0.2, 0.1), measures(0.2, 0.07)).empty());
}

TEST_CASE("a result that loses photographs or one outline is not taken, however good the rest") {
  const SurfaceMeasures start = measures(0.2, 0.1, {0.99, 0.98});
  CHECK(reason_to_keep(start, measures(0.201, 0.05, {1, 1})) ==
        "the dissimilarity of the result is 0.2010, but that of the initial mesh is 0.2000");
  CHECK(reason_to_keep(start, measures(0.1, 0.05, {1, 0.9781})).empty());
  CHECK(reason_to_keep(start, measures(0.1, 0.05, {1, 0.9779})) ==
        "the overlap of the result's outline and a silhouette is 0.9779, but that of the initial "
        "mesh is "
        "0.9800");
}

TEST_CASE("the mean agreement of outlines is 1 without masks") {
  CHECK(measures(0, 0).mean_outline() == 1);
  CHECK(measures(0, 0, {0.5, 1}).mean_outline() == 0.75);
}
