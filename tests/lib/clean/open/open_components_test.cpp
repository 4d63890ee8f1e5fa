/// The closed part of a mesh, checked by sums along edges that are counted by hand.
#include "clean/open/open_components.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "clean/intersect/find_meetings.h"
#include "clean/open/borders.h"
#include "clean/open/enclosed_sheets.h"
#include "helpers/random.h"
#include "helpers/shapes.h"

using namespace transformesh;

namespace {

std::vector<Index> components_of(const Mesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  const auto find_enclosed = [&] {
    const auto shared = std::make_shared<const WeldedMesh>(welded);
    const std::vector<Meeting> meetings = find_meetings(welded, Progress());
    return find_enclosed_sheets(arrange(shared, meetings, Progress()), 1, Progress());
  };
  return find_open_components(mesh, welded, is_stitched(mesh, find_borders(welded, mesh)),
                              find_enclosed);
}

std::size_t count_closed(const Mesh& mesh) {
  const std::vector<Index> components = components_of(mesh);
  return static_cast<std::size_t>(std::count(components.begin(), components.end(), no_index));
}

std::size_t count_open_components(const Mesh& mesh) {
  const std::vector<Index> components = components_of(mesh);
  std::set<Index> different(components.begin(), components.end());
  different.erase(no_index);
  return different.size();
}

Mesh wall(double x) {
  Mesh mesh;
  mesh.positions = {{x, 0, 0}, {x, 1, 0}, {x, 1, 1}, {x, 0, 1}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// A box of 2 x 1 x 1 whose faces have an edge at x = 1.
Mesh two_cells() {
  Mesh mesh = test::joined(test::cube(), test::moved(test::cube(), {1, 0, 0}));
  std::erase_if(mesh.faces, [&](const Face& f) {
    return std::all_of(f.begin(), f.end(), [&](Index v) { return mesh.positions[v].x() == 1; });
  });
  return mesh;
}

}  // namespace

TEST_CASE("a closed mesh has no open component, indexed or not") {
  CHECK(count_closed(test::icosphere(2)) == test::icosphere(2).faces.size());
  CHECK(count_closed(test::soup_of(test::icosphere(2))) == test::icosphere(2).faces.size());
}

TEST_CASE("sheets are open components beside a closed part") {
  const Mesh mesh = test::joined(test::icosphere(1), test::joined(test::grid(3), wall(5)));
  CHECK(count_closed(mesh) == test::icosphere(1).faces.size());
  CHECK(count_open_components(mesh) == 2);
}

TEST_CASE("a wall between two cells is open, and the skin around both is closed") {
  for (const bool is_reversed : {false, true}) {
    const Mesh middle = is_reversed ? test::reversed(wall(1)) : wall(1);
    const Mesh mesh = test::joined(two_cells(), middle);
    CHECK(count_closed(mesh) == two_cells().faces.size());
    CHECK(count_open_components(mesh) == 1);
  }
}

TEST_CASE("a fin at an edge of a body is open") {
  Mesh fin;
  fin.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, -1, -1}};
  fin.faces = {{0, 1, 2}};
  const Mesh mesh = test::joined(test::cube(), fin);
  CHECK(count_closed(mesh) == test::cube().faces.size());
  CHECK(count_open_components(mesh) == 1);
}

TEST_CASE("a dome whose border lies on a body with vertices of its own is open") {
  // The body is closed by its indices, although the dome has more area than the face that it
  // covers.
  const Mesh body = test::cuboid({0, 0, -1}, {1, 1, 0});
  Mesh dome;
  dome.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 2}};
  dome.faces = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  CHECK(count_closed(test::joined(body, dome)) == body.faces.size());
  CHECK(count_closed(test::joined(dome, body)) == body.faces.size());
}

TEST_CASE("the closed part does not depend on the order of faces") {
  test::Random random(5);
  const Mesh mesh = test::joined(test::joined(two_cells(), wall(1)), test::grid(2));
  const std::size_t closed = count_closed(mesh);
  for (int round = 0; round < 20; ++round) {
    Mesh shuffled = mesh;
    for (std::size_t i = shuffled.faces.size(); i > 1; --i)
      std::swap(shuffled.faces[i - 1], shuffled.faces[random.below(i)]);
    CHECK(count_closed(shuffled) == closed);
  }
}
