// Report entries of surfaces: their values in closed form, and the order in which programs print
// them.
#include <doctest/doctest.h>

#include "entries/entries.h"
#include "helpers/shapes.h"
#include "transformesh/check_mesh.h"
#include "transformesh/clean.h"
#include "transformesh/transform.h"

using namespace transformesh;

namespace {

template <typename Held>
Held value_of(const Entries& entries, const std::string& name) {
  for (const auto& [key, value] : entries)
    if (key == name) return std::get<Held>(value);
  FAIL("no entry ", name);
  return {};
}

}  // namespace

TEST_CASE("a box of sides 1, 2 and 3 is described by its counts and sizes") {
  const Entries entries = describe(test::cuboid(Vec3::Zero(), {1, 2, 3}));
  CHECK(value_of<std::size_t>(entries, "vertices") == 8);
  CHECK(value_of<std::size_t>(entries, "faces") == 12);
  CHECK(value_of<std::size_t>(entries, "edges") == 18);
  CHECK(value_of<std::size_t>(entries, "components") == 1);
  CHECK(value_of<long>(entries, "genus") == 0);
  CHECK(value_of<double>(entries, "area") == doctest::Approx(22));
  CHECK(value_of<double>(entries, "volume") == doctest::Approx(6));
  CHECK(value_of<std::vector<double>>(entries, "bbox_max") == std::vector<double>{1, 2, 3});
  CHECK(value_of<double>(entries, "edge_max") == doctest::Approx(std::sqrt(13)));
}

TEST_CASE("a torus has genus 1 and a disk one boundary loop") {
  CHECK(value_of<long>(describe(test::torus(2, 1, 12, 8)), "genus") == 1);
  Mesh open = test::tetrahedron();
  open.faces.pop_back();
  CHECK(value_of<std::size_t>(describe(open), "boundary_loops") == 1);
}

TEST_CASE("entries keep the order of the report, and appended ones follow") {
  Entries entries = entries_of(CleanResult());
  CHECK(entries.front().first == "changed");
  CHECK(entries.back().first == "separation_refused");
  append(entries, entries_of(TransformResult{true, 2}));
  CHECK(entries.back().first == "mirrored");
  CHECK(value_of<bool>(entries, "mirrored"));
  CHECK(value_of<double>(entries, "scale") == 2);
}

TEST_CASE("a check of a mesh has entries only for requested checks") {
  CHECK(entries_of(check_mesh(test::cube())).back().first == "genus");
  CheckMeshOptions options;
  options.intersections = true;
  CHECK(entries_of(check_mesh(test::cube(), options)).back().first == "intersections");
}
