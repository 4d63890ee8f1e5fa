#include "step/estimate_normals.h"

#include <doctest/doctest.h>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

/// Changes the order, so that neighbors in space do not have neighboring indices.
std::vector<Index> shuffled(std::size_t count) {
  test::Random random(11);
  std::vector<Index> order(count);
  for (Index i = 0; i < count; ++i) order[i] = i;
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

/// Returns the smallest cosine between the estimate and the true normals of a mesh's vertices.
double least_cosine(const Mesh& mesh) {
  const std::vector<Vec3> truth = vertex_normals(mesh);
  const std::vector<Index> order = shuffled(truth.size());
  std::vector<Vec3> points;
  for (const Index v : order) points.push_back(mesh.positions[v]);
  const std::vector<Vec3> normals = estimate_normals(points);
  double least = 1;
  for (std::size_t i = 0; i < order.size(); ++i) {
    CHECK(normals[i].norm() == doctest::Approx(1));
    least = std::min(least, normals[i].dot(truth[order[i]]));
  }
  return least;
}

}  // namespace

TEST_CASE("normals of closed surfaces are found and look outwards") {
  CHECK(least_cosine(test::icosphere(3)) > 0.99);
  CHECK(least_cosine(test::torus(1, 0.4, 60, 30)) > 0.99);
}

TEST_CASE("normals of several bodies are oriented outwards") {
  const Mesh sphere = test::icosphere(3);
  CHECK(least_cosine(test::joined(sphere, test::moved(sphere, {5, 0, 0}))) > 0.99);
}

TEST_CASE("normals do not depend on the number of threads") {
  const std::vector<Vec3> points = test::torus(1, 0.4, 60, 30).positions;
  const std::vector<Vec3> alone = [&] {
    const ThreadLimit limit(1);
    return estimate_normals(points);
  }();
  const ThreadLimit limit(4);
  CHECK(estimate_normals(points) == alone);
}

TEST_CASE("too few points are refused, coincident ones have no normal") {
  CHECK_THROWS_AS(estimate_normals(std::vector<Vec3>(3, Vec3::Zero())), InputError);
  for (const Vec3& normal : estimate_normals(std::vector<Vec3>(50, Vec3::Ones())))
    CHECK(normal == Vec3::Zero());
}
