#include "clean/intersect/face_strips.h"

#include <doctest/doctest.h>

#include <numeric>

#include "clean/intersect/contacts.h"
#include "helpers/random.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

/// Long thin faces side by side, along y and near the plane z = 0, then rotated and shifted.
Mesh needles(std::size_t count, double width, double height, double scale, const Vec3& move) {
  test::Random random(43);
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  Mesh mesh;
  const auto add = [&](double x, double y) {
    const Vec3 point(x, y, random.uniform(-height, height));
    mesh.positions.emplace_back(scale * (turn * point + move));
  };
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(0, 1), first = random.uniform(0, 0.2);
    const auto v = static_cast<Index>(mesh.positions.size());
    add(x, first);
    add(x + random.uniform(-1, 1) * width, first + random.uniform(0, 1));
    add(x + width, first);
    mesh.faces.push_back({v, v + 1, v + 2});
  }
  return mesh;
}

struct Counts {
  std::size_t apart = 0, meet = 0, neither = 0;
};

/// Compares the answers of strips with the exact test, for all pairs.
Counts compare_all(const Mesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  std::vector<Index> faces(welded.faces.size());
  std::iota(faces.begin(), faces.end(), Index{0});
  const FaceStrips strips(welded, faces);
  Counts counts;
  for (Index f = 0; f < faces.size(); ++f)
    for (Index g = f + 1; g < faces.size(); ++g) {
      const bool meet = find_contacts(welded, f, g).meet, apart = strips.are_apart(f, g);
      REQUIRE(!(meet && apart));
      ++(meet ? counts.meet : apart ? counts.apart : counts.neither);
    }
  return counts;
}

}  // namespace

TEST_CASE("faces that strips show to be apart do not meet") {
  for (const double width : {1e-1, 1e-3, 1e-8})
    for (const double height : {0.0, 1e-15, 1e-6, 1e-2})
      for (const double scale : {1.0, 1e-70, 1e70})
        for (const Vec3& move : {Vec3(0, 0, 0), Vec3(1e3, -7, 1e6)}) {
          const Counts counts = compare_all(needles(150, width, height, scale, move));
          CHECK((width == 1e-1 || counts.apart > 1000));
        }
}

TEST_CASE("most thin faces side by side are shown to be apart") {
  const Counts counts = compare_all(needles(300, 1e-4, 1e-9, 1, Vec3(1, 2, 3)));
  CHECK(counts.apart > 100 * (counts.meet + counts.neither));
}

TEST_CASE("faces of extreme size have no strips") {
  for (const double scale : {1e-300, 1e-90, 1e90, 1e300})
    CHECK(compare_all(needles(150, 1e-3, 1e-6, scale, Vec3(1, 2, 3))).apart == 0);
}

// Corners are lattice points, so that many faces touch in a point or an edge, or are coplanar.
TEST_CASE("thin faces that touch are not shown to be apart") {
  test::Random random(7);
  Mesh mesh;
  const auto coordinate = [&](double size) { return std::floor(random.uniform(0, size)); };
  for (Index i = 0; i < 300; ++i) {
    const double x = coordinate(4), y = coordinate(4);
    const Vec3 from(x, y, coordinate(2));
    mesh.positions.push_back(from);
    mesh.positions.push_back(from + Vec3(20, coordinate(5) - 2, coordinate(3) - 1));
    mesh.positions.push_back(from + Vec3(1, 1, 0));
    mesh.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Counts counts = compare_all(mesh);
  CHECK(counts.meet > 1000);
  CHECK(counts.apart > 1000);
}
