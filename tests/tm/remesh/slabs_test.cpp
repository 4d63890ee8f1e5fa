#include "tm/remesh/slabs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>

#include "helpers/shapes.h"
#include "tm/remesh/collapse.h"
#include "tm/remesh/flip.h"
#include "tm/remesh/remesh_checks.h"
#include "tm/remesh/slab_edits.h"
#include "tm/remesh/smooth.h"
#include "tm/support/parallel.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// Large enough for four slabs.
Mesh wide_torus() { return torus(8, 1, 320, 40); }

/// What some of the operations make of the mesh with that many threads.
Mesh edited(const Mesh& mesh, int threads) {
  const ThreadLimit limit(threads);
  EditableMesh editable(mesh);
  const EdgeLimits limits{0.14, 0.3};
  EmbeddingGuard guard(editable, limits.stretched());
  CHECK(guard.slabs().size() >= 4);
  const VertexRoles roles(editable, false);
  CHECK(collapse_short_edges(editable, guard, roles, limits, {}).done > 100);
  CHECK(flip_edges(editable, guard, FlipRule::valence, limits, {}).done > 100);
  CHECK(relax_tangentially(editable, guard, roles, nullptr, {}).moved > 100);
  return editable.to_mesh();
}

}  // namespace

TEST_CASE("slabs hold each living vertex once and are as thick as asked for") {
  EditableMesh mesh(wide_torus());
  const double thickness = 1.25;
  const Slabs slabs(mesh, thickness);
  REQUIRE(slabs.size() == 8);
  std::vector<int> times(mesh.vertex_slots(), 0);
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    CHECK(std::is_sorted(slabs.vertices(i).begin(), slabs.vertices(i).end()));
    CHECK(slabs.vertices(i).size() > mesh.vertex_slots() / 10);
    CHECK(slabs[i].high - slabs[i].low > 0.999 * thickness);
    for (const Index v : slabs.vertices(i)) {
      ++times[v];
      CHECK(slabs[i].holds(mesh.position(v)));
      CHECK(slabs.of(v) == i);
    }
    if (i > 0) CHECK(slabs[i].low == slabs[i - 1].high);
  }
  CHECK(std::count(times.begin(), times.end(), 1) == std::ptrdiff_t{mesh.vertex_slots()});
}

TEST_CASE("a mesh that is small or narrow is one slab") {
  CHECK(Slabs(EditableMesh(icosphere(3)), 0.01).size() == 1);
  CHECK(Slabs(EditableMesh(wide_torus()), 20).size() == 1);
  CHECK(Slabs(EditableMesh(wide_torus())).size() == 1);
}

TEST_CASE("no two slabs side by side are edited at the same time, and all are finished in turn") {
  const ThreadLimit limit(4);
  const EditableMesh mesh(wide_torus());
  const Slabs slabs(mesh, 0.5);
  REQUIRE(slabs.size() >= 8);
  std::vector<std::atomic<int>> is_edited(slabs.size());
  std::vector<std::size_t> finished;
  slabs.for_each(
      [&](std::size_t slab) {
        is_edited[slab] = 1;
        CHECK((slab == 0 || is_edited[slab - 1] != 1));
        CHECK((slab + 1 == slabs.size() || is_edited[slab + 1] != 1));
        is_edited[slab] = 2;
      },
      [&](std::size_t slab) { finished.push_back(slab); });
  REQUIRE(finished.size() == slabs.size());
  CHECK(std::all_of(is_edited.begin(), is_edited.end(), [](int state) { return state == 2; }));
  CHECK(finished[0] == 0);
  CHECK(finished[1] == 2);
  CHECK(finished.back() == slabs.size() - 1);
}

TEST_CASE("the guard of a part leaves what lies elsewhere or needs a new cell to the whole one") {
  EditableMesh mesh(wide_torus());
  EmbeddingGuard whole(mesh, 0.3);
  const Slabs& slabs = whole.slabs();
  REQUIRE(slabs.size() == 4);
  EmbeddingGuard part(whole, slabs[1]);
  const Index inside = slabs.vertices(1)[0];
  CHECK(part.is_part());
  CHECK(part.may_edit(inside));
  CHECK_FALSE(part.may_edit(slabs.vertices(2)[0]));
  CHECK(whole.may_edit(slabs.vertices(2)[0]));

  Patch patch;
  patch.center = inside;
  patch.center_position = mesh.position(inside);
  CHECK(part.has_room(patch));
  CHECK_FALSE(part.was_put_off());
  patch.center_position += Vec3(0, 0, 100);
  CHECK_FALSE(part.has_room(patch));
  CHECK(part.was_put_off());
  CHECK_FALSE(part.was_put_off());
  CHECK(whole.has_room(patch));
}

TEST_CASE("what is left over in slabs is edited by the whole guard") {
  EditableMesh mesh(wide_torus());
  EmbeddingGuard guard(mesh, 0.3);
  std::vector<int> times(mesh.vertex_slots(), 0);
  const EditCounts counts = edit_in_slabs(
      guard, [&](std::size_t slab) -> const auto& { return guard.slabs().vertices(slab); },
      [&](EmbeddingGuard& own, std::span<const Index> vertices, std::vector<Index>& left) {
        for (const Index v : vertices) {
          if (own.is_part() && v % 3 == 0) {
            left.push_back(v);
          } else {
            ++times[v];
          }
        }
        return EditCounts{vertices.size(), 0};
      });
  CHECK(counts.done > mesh.vertex_slots());
  CHECK(std::count(times.begin(), times.end(), 1) == std::ptrdiff_t{mesh.vertex_slots()});
}

TEST_CASE("edits in slabs are the same for any number of threads") {
  const Mesh mesh = wide_torus();
  const Mesh one = edited(mesh, 1);
  CHECK(is_oriented_manifold(one));
  CHECK(is_closed(one));
  for (const int threads : {2, 4, 8}) {
    const Mesh other = edited(mesh, threads);
    CHECK(other.positions == one.positions);
    CHECK(other.faces == one.faces);
  }
}
