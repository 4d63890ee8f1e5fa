#include "remesh/guards/embedding_guard.h"

#include <algorithm>

#include "helpers/shapes.h"
#include "remesh/operations/vertex_mover.h"
#include "transformesh/measure.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// Returns the faces around a vertex if it were at another position.
Patch star_moved_to(const EditableMesh& mesh, Index vertex, const Vec3& position) {
  VertexStar star;
  star.gather(mesh, vertex);
  Patch patch;
  patch.center = vertex;
  patch.center_position = position;
  patch.vertices.push_back(vertex);
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Vec3 a = star.rim(i) - position;
    const Vec3 b = star.rim(i + 1) - position;
    patch.made.push_back({position, star.rim(i), star.rim(i + 1)});
    patch.normals.push_back(a.cross(b));
    patch.longest_squared =
        std::max({patch.longest_squared, a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
    patch.vertices.push_back(star.ring()[i]);
  }
  mesh.for_each_outgoing(vertex, [&](Index halfedge) { patch.replaced.push_back(halfedge / 3); });
  return patch;
}

/// A ball of radius 1 below the middle of a face of a tetrahedron that is scaled by 50, and the
/// ball's highest vertex.
struct BallUnderFace {
  Mesh mesh;
  Index top = 0;

  BallUnderFace() {
    const Mesh large = scaled(tetrahedron(), 50);
    const auto& [a, b, c] = large.faces[0];
    const Vec3 middle = (large.positions[a] + large.positions[b] + large.positions[c]) / 3;
    up = face_normal(large, 0).normalized();
    mesh = joined(large, moved(icosphere(1), middle - 1.1 * up));
    const auto height = [&](Index v) { return mesh.positions[v].dot(up); };
    top = static_cast<Index>(large.positions.size());
    for (Index v = top; v < mesh.positions.size(); ++v)
      if (height(v) > height(top)) top = v;
  }
  Vec3 up = Vec3::Zero();
};

}  // namespace

TEST_CASE("a patch that meets a large face far from all its corners is refused") {
  const BallUnderFace scene;
  for (const bool has_sizes : {false, true}) {
    CAPTURE(has_sizes);
    EditableMesh mesh(scene.mesh);
    if (has_sizes) mesh.set_sizes(std::vector<double>(scene.mesh.positions.size(), 1));
    EmbeddingGuard guard(mesh, 1);
    const Vec3& top = mesh.position(scene.top);
    CHECK(guard.allows(star_moved_to(mesh, scene.top, top)));
    CHECK(guard.allows(star_moved_to(mesh, scene.top, top - 0.05 * scene.up)));
    CHECK_FALSE(guard.allows(star_moved_to(mesh, scene.top, top + 0.3 * scene.up)));
  }
}

TEST_CASE("a face enlarged by a patch is found far from its corners") {
  // The top of a ball is drawn out into a spike that passes a small ball.
  const Mesh large = icosphere(2);
  const Index top = 0;
  const Vec3 up = large.positions[top];
  const Vec3 aside = up.unitOrthogonal();
  const Mesh small = moved(scaled(icosphere(1), 0.1), 2 * up + 0.35 * aside);
  EditableMesh mesh(joined(large, small));
  mesh.set_sizes(std::vector<double>(large.positions.size() + small.positions.size(), 1));
  EmbeddingGuard guard(mesh, 4);

  auto near = static_cast<Index>(large.positions.size());
  for (Index v = near; v < mesh.vertex_slots(); ++v)
    if (mesh.position(v).dot(aside) < mesh.position(near).dot(aside)) near = v;
  const Patch piercing = star_moved_to(mesh, near, 2 * up);
  CHECK(guard.allows(piercing));
  const Patch spike = star_moved_to(mesh, top, 3 * up);
  CHECK(guard.allows(spike));
  mesh.move(top, 3 * up);
  guard.commit(spike);
  CHECK_FALSE(guard.allows(piercing));
  CHECK(guard.allows(star_moved_to(mesh, near, mesh.position(near) + 0.01 * aside)));
}
