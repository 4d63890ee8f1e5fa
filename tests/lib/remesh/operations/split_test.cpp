#include "remesh/operations/split.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "mesh/coordinate_spacing.h"
#include "transformesh/intersect.h"
#include "transformesh/measure.h"
#include "transformesh/remesh.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// A square of random triangles within a plane that is oblique to all axes.
Mesh oblique_sheet(int n, double height, test::Random& random) {
  Mesh mesh = grid(n);
  for (Vec3& p : mesh.positions) {
    const bool inside = p.x() > 0 && p.x() < 1 && p.y() > 0 && p.y() < 1;
    if (inside) p += Vec3(random.uniform(-0.25, 0.25), random.uniform(-0.25, 0.25), 0) / n;
    p.z() = height;
    p = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) * p;
    for (double& x : p) x = round_to_single(x + 0.31);
  }
  return mesh;
}

}  // namespace

TEST_CASE("edges are halved until none is too long, on the surface as it was") {
  EditableMesh mesh(cube());
  const std::size_t splits = split_long_edges(mesh, {0.3, false}, {}).done;
  const Mesh fine = mesh.to_mesh();
  CHECK(is_oriented_manifold(fine));
  CHECK(fine.positions.size() == 8 + splits);
  CHECK(edge_lengths(fine).maximum <= 0.3);
  CHECK(volume(fine) == doctest::Approx(1).epsilon(1e-14));
  for (const Vec3& p : fine.positions) {
    CHECK((2 * p - Vec3::Ones()).cwiseAbs().maxCoeff() == 1);  // on the cube, exactly
  }
}

TEST_CASE("beside border edges that stay and are far too long, splits end") {
  const auto side = [](const Mesh& mesh, Index a, Index b) {
    return (mesh.positions[a] - mesh.positions[b]).norm();
  };
  for (const int cells : {1, 2, 3, 8})
    for (const double limit : {5e-3, 0.02, 0.1, 0.3, 0.45, 0.6, 0.7, 0.9}) {
      CAPTURE(cells);
      CAPTURE(limit);
      EditableMesh editable(grid(cells));
      split_long_edges(editable, {limit, true}, {});
      const Mesh mesh = editable.to_mesh();
      CHECK(is_oriented_manifold(mesh));

      // Maps each edge to the length of the longest edge of the faces beside it.
      std::map<std::pair<Index, Index>, double> beside;
      for (const Face& face : mesh.faces) {
        const double longest = std::max({side(mesh, face[0], face[1]), side(mesh, face[1], face[2]),
                                         side(mesh, face[2], face[0])});
        for (int i = 0; i < 3; ++i) {
          auto& most = beside[std::minmax(face[i], face[(i + 1) % 3])];
          most = std::max(most, longest);
        }
      }
      int border = 0;
      for (const auto& [edge, faces] : edge_faces(mesh)) {
        const double length = side(mesh, edge.first, edge.second);
        if (faces == 1) {
          ++border;
          CHECK(length == doctest::Approx(1.0 / cells));
        } else if (length > limit) {
          CHECK(beside[edge] > length);
          CHECK(beside[edge] > 1.5 * limit);
        }
      }
      CHECK(border == 4 * cells);
    }
}

TEST_CASE("sheets of floats one rounding apart do not cross where edges are split") {
  // Without settle_midpoints(), a tenth of the pairs would intersect.
  std::size_t tried = 0;
  std::size_t crossed = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    test::Random random(seed);
    Mesh mesh = joined(oblique_sheet(3, 0, random),
                       oblique_sheet(4, random.uniform(0.45e-7, 1e-7), random));
    tried += find_intersections(mesh).empty();
    RemeshOptions options;
    options.min_edge = 1e-6;
    options.max_edge = 0.15;
    options.flip = FlipRule::none;
    options.smoothing = Smoothing::none;
    options.coordinate = Scalar::float32;
    remesh(mesh, options);
    crossed += find_intersections(mesh).empty() ? 0 : 1;
  }
  CHECK(tried == 300);
  CHECK(crossed == 0);
}
