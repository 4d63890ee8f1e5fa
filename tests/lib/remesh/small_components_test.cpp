#include "remesh/small_components.h"

#include <doctest/doctest.h>

#include <numbers>

#include "helpers/shapes.h"
#include "transformesh/components.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

Mesh box(const Vec3& sides) { return test::cuboid(Vec3::Zero(), sides); }

RemeshResult::RemovedComponents removed_from(const Mesh& mesh, double edge,
                                             bool keep_border = false) {
  EditableMesh editable(mesh);
  const auto removed = remove_small_components(editable, edge, keep_border);
  CHECK(editable.to_mesh().faces.size() + removed.faces == mesh.faces.size());
  return removed;
}

}  // namespace

TEST_CASE("a cube is removed if its edges, its volume and its sides are small") {
  // The diagonals of a cube's sides are edges of length 1.41. Its principal axes are arbitrary, so
  // an extent along them is at most its diagonal of 1.73.
  CHECK(removed_from(box({1, 1, 1}), 1.41).count == 0);
  const auto removed = removed_from(box({1, 1, 1}), 1.74);
  CHECK(removed.count == 1);
  CHECK(removed.faces == 12);
  CHECK(removed.area == doctest::Approx(6));
  CHECK(removed.volume == doctest::Approx(1));
}

TEST_CASE("a plate that is wider than the edge stays, however thin it is") {
  CHECK(removed_from(box({3, 3, 1e-6}), 1).count == 0);
  CHECK(removed_from(box({1e-3, 1e-3, 0.9}), 1).count == 1);
}

TEST_CASE("small components are removed, and the rest keeps its order") {
  const Mesh mesh =
      test::joined(test::moved(box({0.1, 0.1, 0.1}), {5, 0, 0}),
                   test::joined(box({2, 2, 2}), test::moved(box({0.2, 0.2, 0.2}), {0, 5, 0})));
  EditableMesh editable(mesh);
  const auto removed = remove_small_components(editable, 1, false);
  CHECK(removed.count == 2);
  CHECK(removed.volume == doctest::Approx(0.001 + 0.008));
  const Mesh left = editable.to_mesh();
  CHECK(left.faces.size() == 12);
  CHECK(volume(left) == doctest::Approx(8));
}

TEST_CASE("components with a border stay if borders are kept") {
  Mesh open = box({0.1, 0.1, 0.1});
  open.faces.pop_back();
  CHECK(removed_from(open, 1, true).count == 0);
  CHECK(removed_from(open, 1, false).count == 1);
}

TEST_CASE("sizes of the mesh multiply the edge") {
  // The limit for the cube is between 1.41 and 1.74. Sizes of 10 multiply edges of a tenth.
  for (const auto& [edge, count] : {std::pair(0.141, 0U), std::pair(0.174, 1U)}) {
    EditableMesh editable(box({1, 1, 1}));
    editable.set_sizes(std::vector<double>(8, 10));
    CHECK(remove_small_components(editable, edge, false).count == count);
  }
}
