#include "clean/intersect/contacts.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <doctest/doctest.h>

#include "helpers/cgal_versions.h"
#include "helpers/random.h"

// The oracle is CGAL's exact construction of the intersection of two triangles.
using namespace transformesh;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;

Point point(const Vec3& p) { return {p[0], p[1], p[2]}; }

Kernel::Triangle_3 triangle(const Triangle& t) { return {point(t[0]), point(t[1]), point(t[2])}; }

int count_shared(const Face& f, const Face& g) {
  int shared = 0;
  for (const Index a : f) {
    for (const Index b : g) shared += a == b ? 1 : 0;
  }
  return shared;
}

struct Answer {
  bool meet;
  bool coplanar_overlap;
};

// A shared corner or edge alone is not an intersection.
Answer by_cgal(const WeldedMesh& welded, Index f, Index g) {
  const int shared = count_shared(welded.faces[f], welded.faces[g]);
  const auto result =
      CGAL::intersection(triangle(welded.triangle(f)), triangle(welded.triangle(g)));
  if (!result) return {false, false};
  if (test::alternative<Point>(*result)) return {shared == 0, false};
  if (const auto* segment = test::alternative<Kernel::Segment_3>(*result)) {
    if (shared < 2) return {true, false};
    const auto is_corner = [&](const Point& p) {
      for (const Index v : welded.faces[f]) {
        if (point(welded.points[v]) == p) return true;
      }
      return false;
    };
    return {!(is_corner(segment->source()) && is_corner(segment->target())), false};
  }
  return {true, true};
}

WeldedMesh random_pair(test::Random& random, double size) {
  Mesh mesh;
  for (int i = 0; i < 6; ++i) {
    const double x = std::floor(random.uniform(0, size)), y = std::floor(random.uniform(0, size)),
                 z = std::floor(random.uniform(0, size));
    mesh.positions.emplace_back(x, y, z);
  }
  mesh.faces = {{0, 1, 2}, {3, 4, 5}};
  return weld(mesh);
}

}  // namespace

TEST_CASE("two triangles on a lattice meet exactly where CGAL says") {
  test::Random random(11);
  int tested = 0, met = 0, overlaps = 0, neighbors = 0;
  for (int i = 0; i < 30000; ++i) {
    const WeldedMesh welded = random_pair(random, i % 2 == 0 ? 3 : 4);
    if (welded.faces.size() < 2) continue;
    const Contacts contacts = find_contacts(welded, 0, 1);
    const Answer answer = by_cgal(welded, 0, 1);
    REQUIRE(contacts.meet == answer.meet);
    REQUIRE(triangles_meet(welded.triangle(0), welded.triangle(1)) == answer.meet);
    if (answer.coplanar_overlap) REQUIRE(contacts.coplanar);
    ++tested;
    met += answer.meet ? 1 : 0;
    overlaps += answer.coplanar_overlap ? 1 : 0;
    neighbors += count_shared(welded.faces[0], welded.faces[1]) > 0 && answer.meet ? 1 : 0;
  }
  CHECK(tested > 20000);
  CHECK(met > 5000);
  CHECK(overlaps > 100);
  CHECK(neighbors > 100);
}

TEST_CASE("faces in different planes meet in at most one segment") {
  test::Random random(12);
  for (int i = 0; i < 10000; ++i) {
    const WeldedMesh welded = random_pair(random, 4);
    if (welded.faces.size() < 2) continue;
    const Contacts contacts = find_contacts(welded, 0, 1);
    if (contacts.meet && !contacts.coplanar) {
      REQUIRE(contacts.count >= 1);
      REQUIRE(contacts.count <= 2);
    }
  }
}

TEST_CASE("the point of a contact lies on both faces, and is CGAL's end of their segment") {
  test::Random random(13);
  int segments = 0;
  for (int i = 0; i < 5000; ++i) {
    const WeldedMesh welded = random_pair(random, 5);
    if (welded.faces.size() < 2) continue;
    const Contacts contacts = find_contacts(welded, 0, 1);
    if (!contacts.meet || contacts.coplanar) continue;
    const ExactGeometry geometry(welded.points, welded.faces);
    std::vector<Vec3> ends;
    for (int k = 0; k < contacts.count; ++k) {
      const Contact contact = contacts.contacts[static_cast<std::size_t>(k)];
      ends.push_back(geometry.position(contact_point(welded, geometry, 0, 1, contact)));
    }
    const auto common =
        CGAL::intersection(triangle(welded.triangle(0)), triangle(welded.triangle(1)));
    const auto* segment = test::alternative<Kernel::Segment_3>(*common);
    if (segment == nullptr) continue;
    REQUIRE(ends.size() == 2);
    const auto is_at = [](const Vec3& p, const Point& q) {
      return (p - Vec3(CGAL::to_double(q.x()), CGAL::to_double(q.y()), CGAL::to_double(q.z())))
                 .norm() < 1e-14;
    };
    const bool is_same = is_at(ends[0], segment->source()) && is_at(ends[1], segment->target());
    const bool is_swapped = is_at(ends[1], segment->source()) && is_at(ends[0], segment->target());
    REQUIRE((is_same || is_swapped));
    ++segments;
  }
  CHECK(segments > 500);
}
