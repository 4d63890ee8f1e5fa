/// The tree of faces, compared with a search of all faces, while vertices move and edges collapse.
#include "remesh/guards/face_tree.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "geometry/search/closest_point.h"
#include "helpers/shapes.h"
#include "lib/remesh/double_cone.h"
#include "remesh/guards/triangle_contact.h"
#include "support/random.h"

using namespace transformesh;

namespace {

std::vector<Index> found_in(const FaceTree& tree, const EditableMesh& mesh, const Vec3& low,
                            const Vec3& high) {
  std::vector<Index> result;
  tree.for_each_near(low, high, [&](Index face) {
    if (mesh.has_face(face)) result.push_back(face);
    return true;
  });
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Index> all_near(const EditableMesh& mesh, const Vec3& low, const Vec3& high) {
  std::vector<Index> result;
  for (Index face = 0; face < mesh.face_slots(); ++face) {
    if (!mesh.has_face(face)) continue;
    const auto [a, b, c] = mesh.triangle(face);
    const bool meets = (a.cwiseMin(b).cwiseMin(c).array() <= high.array()).all() &&
                       (a.cwiseMax(b).cwiseMax(c).array() >= low.array()).all();
    if (meets) result.push_back(face);
  }
  return result;
}

/// Moves a vertex far away, or collapses one of its edges, and updates the tree.
void change(EditableMesh& mesh, FaceTree& tree, Index vertex, Random& random, bool collapses) {
  std::vector<Index> faces;
  Index edge = no_index;
  mesh.for_each_outgoing(vertex, [&](Index halfedge) {
    faces.push_back(halfedge / 3);
    edge = halfedge;
  });
  const Vec3 place(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2));
  if (collapses && mesh.can_collapse(edge)) {
    mesh.for_each_outgoing(mesh.target(edge), [&](Index h) { faces.push_back(h / 3); });
    mesh.collapse(edge, place, 0.5);
  } else {
    mesh.move(vertex, place);
  }
  for (const Index face : faces) tree.update(face);
}

}  // namespace

TEST_CASE("near faces are those of a search of all faces, whatever moved or collapsed before") {
  EditableMesh mesh(test::icosphere(2));
  FaceTree tree(mesh);
  Random random(7);
  std::size_t found = 0;
  for (int step = 0; step < 400; ++step) {
    const auto vertex = static_cast<Index>(random.uniform(0, mesh.vertex_slots() - 1e-9));
    if (mesh.has_vertex(vertex)) change(mesh, tree, vertex, random, step % 4 == 0);
    const Vec3 low(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2));
    const Vec3 high = low + Vec3::Constant(random.uniform(0, 0.3));
    const std::vector<Index> near = all_near(mesh, low, high);
    const std::vector<Index> in_tree = found_in(tree, mesh, low, high);
    // Boxes in floats are rounded outwards, so a few more faces may be found.
    CHECK(std::includes(in_tree.begin(), in_tree.end(), near.begin(), near.end()));
    CHECK(in_tree.size() <= near.size() + 2);
    found += near.size();
  }
  CHECK(found > 1000);
}

TEST_CASE("few faces at a vertex of high valence are searched, and none that may touch is missed") {
  const EditableMesh mesh(test::double_cone(500));
  const FaceTree tree(mesh);
  for (Index i = 0; i < 500; i += 7) {
    const Triangle wide{mesh.position(500), mesh.position(i), mesh.position((i + 3) % 500)};
    std::vector<char> is_found(mesh.face_slots(), 0);
    tree.for_each_in_contact(wide, [&](Index face) { return is_found[face] = 1; });
    CHECK(std::count(is_found.begin(), is_found.end(), 1) < 40);
    for (Index face = 0; face < mesh.face_slots(); ++face)
      if (!is_found[face]) CHECK_FALSE(may_touch(wide, mesh.triangle(face)));
  }
}

TEST_CASE("the closest face of a double cone is that of a search in all its faces") {
  const Mesh cone = test::double_cone(300);
  const EditableMesh mesh(cone);
  const FaceTree tree(mesh);
  const ClosestPointQuery query(cone);
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const Vec3 at(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const Vec3 point = i % 2 == 0 ? at : Vec3(query(at).point + 1e-3 * at);
    const double distance = i % 3 == 0 ? 0.1 : 2;
    const Index hint = i % 5 == 0 ? no_index : 7;
    CHECK(tree.closest_face_within(point, distance, hint) ==
          query.closest_face_within(point, distance, hint));
  }
  CHECK(tree.closest_face_within(cone.positions[300], 1, 9) == 0);
}

TEST_CASE("a mesh without faces has an empty tree") {
  const EditableMesh mesh{Mesh{}};
  const FaceTree tree(mesh);
  CHECK(found_in(tree, mesh, Vec3::Zero(), Vec3::Ones()).empty());
}
