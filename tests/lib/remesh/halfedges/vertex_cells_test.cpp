#include "remesh/halfedges/vertex_cells.h"

#include <set>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

std::set<Index> vertices_found(const VertexCells& cells, const Vec3& low, const Vec3& high) {
  std::set<Index> found;
  cells.for_each_cell_near(low, high, [&](const VertexCells::Cell& cell) {
    for (Index v = cell.first_vertex; v != no_index; v = cells[v].next) found.insert(v);
    return true;
  });
  return found;
}

/// Every vertex in a random box must be found, and no vertex farther than a cell away.
void check_boxes(const EditableMesh& mesh, const VertexCells& cells, Random& random) {
  for (int i = 0; i < 50; ++i) {
    const Vec3 corner = random.point(-1.5, 1.5);
    const Vec3 low = corner.cwiseMin(corner + random.point(-0.5, 0.5));
    const Vec3 high = low + (corner - low).cwiseAbs();
    const std::set<Index> found = vertices_found(cells, low, high);
    const Vec3 cell = Vec3::Constant(1.000001 * cells.cell_size());
    for (Index v = 0; v < mesh.vertex_slots(); ++v) {
      const Vec3& p = mesh.position(v);
      const auto is_between = [&](const Vec3& from, const Vec3& to) {
        return (p.array() >= from.array()).all() && (p.array() <= to.array()).all();
      };
      if (mesh.has_vertex(v) && is_between(low, high)) CHECK(found.count(v) == 1);
      if (!is_between(low - cell, high + cell)) CHECK(found.count(v) == 0);
    }
  }
}

NormalCone cone_at(const EditableMesh& mesh, Index vertex) {
  NormalCone cone = all_directions;
  mesh.for_each_outgoing(vertex, [&](Index h) {
    const Vec3 normal = mesh.face_normal(h / 3);
    cone &= common_cone(std::span(&normal, 1));
  });
  return cone;
}

}  // namespace

TEST_CASE("the vertices in a box are found, before and after they move or go") {
  Random random(1);
  EditableMesh mesh(icosphere(3));
  VertexCells cells(mesh, 0.2);
  check_boxes(mesh, cells, random);
  for (Index v = 0; v < mesh.vertex_slots(); v += 2) {
    mesh.move(v, mesh.position(v) + random.point(-0.5, 0.5));
    cells.update(v);
  }
  check_boxes(mesh, cells, random);
  cells.remove(4);
  mesh.remove_vertex(4);
  check_boxes(mesh, cells, random);
  CHECK(vertices_found(cells, Vec3::Constant(-3), Vec3::Constant(3)).size() ==
        icosphere(3).positions.size() - 1);
}

TEST_CASE("a search ends where it is told to") {
  const EditableMesh mesh(icosphere(2));
  const VertexCells cells(mesh, 0.2);
  int visited = 0;
  CHECK_FALSE(cells.for_each_cell_near(Vec3::Constant(-2), Vec3::Constant(2),
                                       [&](const VertexCells::Cell&) { return ++visited < 3; }));
  CHECK(visited == 3);
}

TEST_CASE("vertices have the cones of their faces, cells those of theirs and of the cells around") {
  const EditableMesh mesh(icosphere(3));
  const VertexCells cells(mesh, 0.3);
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    CHECK(cells[v].cone == cone_at(mesh, v));
    NormalCone own = all_directions;
    for (Index w = cells.cell_of(v).first_vertex; w != no_index; w = cells[w].next)
      own &= cone_at(mesh, w);
    CHECK(cells.cell_of(v).cone == own);
    for (Index w = 0; w < mesh.vertex_slots(); ++w) {
      const bool is_near = (mesh.position(v) - mesh.position(w)).norm() <= cells.cell_size();
      if (is_near) CHECK((cells.cell_of(v).cone_around & ~cone_at(mesh, w)) == 0);
    }
  }
}

TEST_CASE("faces that are replaced restrict the cones of vertex, cell and cells around") {
  const EditableMesh mesh(icosphere(2));
  VertexCells cells(mesh, 0.5);
  const NormalCone lowest_bit = cells[0].cone & ~(cells[0].cone - 1);
  REQUIRE(lowest_bit != cells[0].cone);
  cells.restrict(std::vector<Index>{0}, lowest_bit, 0);
  CHECK(cells[0].cone == lowest_bit);
  CHECK((cells.cell_of(0).cone & ~lowest_bit) == 0);
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    const bool is_near = (mesh.position(v) - mesh.position(0)).norm() < cells.cell_size();
    if (is_near) CHECK((cells.cell_of(v).cone_around & ~lowest_bit) == 0);
  }
}

TEST_CASE("closed components are named by their lowest vertices, those with a border are not") {
  const Mesh ball = icosphere(1);
  const auto count = static_cast<Index>(ball.positions.size());
  const EditableMesh mesh(joined(joined(ball, moved(ball, {5, 0, 0})), moved(grid(3), {10, 0, 0})));
  const VertexCells cells(mesh, 0.5);
  CHECK(cells[0].component == 0);
  CHECK(cells[count - 1].component == 0);
  CHECK(cells[count].component == count);
  CHECK(cells[2 * count - 1].component == count);
  CHECK(cells[2 * count].component == no_index);
  CHECK(cells.cell_of(2 * count).cone == 0);
}

TEST_CASE("near another component no direction is in front of all faces") {
  const Mesh ball = icosphere(2);
  const EditableMesh mesh(joined(ball, moved(ball, {2.05, 0, 0})));
  const VertexCells cells(mesh, 0.2);
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    if (std::abs(mesh.position(v).x() - 1.025) < 0.05) CHECK(cells.cell_of(v).cone_around == 0);
    if (mesh.position(v).x() < -0.9) CHECK(cells.cell_of(v).cone_around != 0);
  }
}

TEST_CASE("with sizes the longest edges of the faces at a vertex are known") {
  EditableMesh mesh(cube());
  CHECK(VertexCells(mesh, 1)[0].longest_squared == HUGE_VALF);
  mesh.set_sizes(std::vector<double>(8, 1));
  VertexCells cells(mesh, 1);
  for (Index v = 0; v < 8; ++v) CHECK(cells[v].longest_squared == doctest::Approx(2));
  cells.restrict(std::vector<Index>{3}, all_directions, 5);
  CHECK(cells[3].longest_squared == doctest::Approx(5));
  CHECK(cells[3].longest_squared >= 5);
}
