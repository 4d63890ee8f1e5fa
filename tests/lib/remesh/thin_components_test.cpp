#include "remesh/thin_components.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "remesh/small_components.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

Mesh box(const Vec3& sides) { return test::cuboid(Vec3::Zero(), sides); }

RemeshResult::RemovedComponents removed_from(const Mesh& mesh, double edge) {
  EditableMesh editable(mesh);
  const auto removed = remove_thin_components(editable, edge);
  CHECK(editable.to_mesh().faces.size() + removed.faces == mesh.faces.size());
  return removed;
}

}  // namespace

TEST_CASE("a needle that is longer than the edge is thin") {
  const Mesh needle = box({0.01, 0.02, 3});
  EditableMesh editable(needle);
  CHECK(remove_small_components(editable, 1, false).count == 0);
  const auto removed = removed_from(needle, 1);
  CHECK(removed.count == 1);
  CHECK(removed.faces == 12);
  CHECK(removed.area == doctest::Approx(2 * (0.0002 + 0.03 + 0.06)));
  CHECK(removed.volume == doctest::Approx(0.0006));
}

TEST_CASE("the limit is the area of the sphere whose diameter is the edge") {
  // Six squares of side 0.72 have an area of 3.11, those of side 0.73 have 3.20.
  CHECK(removed_from(box({0.72, 0.72, 0.72}), 1).count == 1);
  CHECK(removed_from(box({0.73, 0.73, 0.73}), 1).count == 0);
  CHECK(removed_from(box({1.25, 1.25, 1e-6}), 1).count == 1);
  CHECK(removed_from(box({1.26, 1.26, 1e-6}), 1).count == 0);
}

TEST_CASE("a component without a short edge stays") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  // Four equilateral triangles of side 1.414 have an area of 3.46, the sphere of diameter 1.41 has
  // 6.25.
  CHECK(removed_from(mesh, 1.41).count == 0);
  CHECK(removed_from(mesh, 1.42).count == 1);
}

TEST_CASE("a thin component with a border stays") {
  Mesh open = box({0.1, 0.1, 3});
  open.faces.pop_back();
  CHECK(removed_from(open, 1).count == 0);
}

TEST_CASE("two needles are removed, and the rest of the mesh keeps its order") {
  const Mesh needle = box({0.01, 0.01, 3});
  const Mesh mesh = test::joined(test::moved(needle, {5, 0, 0}),
                                 test::joined(box({2, 2, 0.1}), test::moved(needle, {0, 5, 0})));
  EditableMesh editable(mesh);
  CHECK(remove_thin_components(editable, 1).count == 2);
  const Mesh left = editable.to_mesh();
  CHECK(left.faces == box({2, 2, 0.1}).faces);
  CHECK(left.positions == box({2, 2, 0.1}).positions);
}

TEST_CASE("sizes of the mesh multiply the edge of thin components") {
  for (const auto& [edge, count] : {std::pair(0.137, 0U), std::pair(0.139, 1U)}) {
    // The sphere of the area of a unit cube has a diameter of 1.382.
    EditableMesh editable(box({1, 1, 1}));
    editable.set_sizes(std::vector<double>(8, 10));
    CHECK(remove_thin_components(editable, edge).count == count);
  }
}
