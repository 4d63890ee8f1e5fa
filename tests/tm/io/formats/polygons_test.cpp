#include "tm/io/formats/polygons.h"

#include <doctest/doctest.h>

#include <map>

#include "helpers/random.h"

using namespace transformesh;

namespace {

struct Cut {
  std::vector<Face> faces;
  std::vector<std::string> notes;
};

Cut cut(const std::vector<Index>& corners) {
  PolygonFans polygons;
  polygons.add(corners);
  Mesh mesh;
  Cut result;
  polygons.move_into(mesh, "off", result.notes);
  result.faces = mesh.faces;
  return result;
}

/// How often more an edge is run forth than back.
using Boundary = std::map<std::pair<Index, Index>, int>;

void add_edge(Boundary& boundary, Index from, Index to) {
  if (from == to) return;
  const auto edge = std::minmax(from, to);
  if ((boundary[edge] += from < to ? 1 : -1) == 0) boundary.erase(edge);
}

Boundary boundary_of(const std::vector<Index>& corners) {
  Boundary boundary;
  for (std::size_t i = 0; i < corners.size(); ++i)
    add_edge(boundary, corners[i], corners[(i + 1) % corners.size()]);
  return boundary;
}

Boundary boundary_of(const std::vector<Face>& faces) {
  Boundary boundary;
  for (const Face& face : faces)
    for (int i = 0; i < 3; ++i) add_edge(boundary, face[i], face[(i + 1) % 3]);
  return boundary;
}

}  // namespace

TEST_CASE("a polygon becomes a fan from its first corner") {
  CHECK(cut({4, 5, 6, 7, 8}).faces == std::vector<Face>{{4, 5, 6}, {4, 6, 7}, {4, 7, 8}});
  CHECK(cut({4, 5, 6, 7}).notes == std::vector<std::string>{"off: 1 polygon cut into 2 triangles"});
}

TEST_CASE("repeated corners and spikes go, and what is visited again becomes a loop of its own") {
  CHECK(cut({0, 0, 1, 1, 2, 2}).faces == std::vector<Face>{{0, 1, 2}});
  CHECK(cut({0, 1, 2, 3, 2}).faces == std::vector<Face>{{0, 1, 2}});
  CHECK(cut({0, 1, 2, 0, 3, 4}).faces == std::vector<Face>{{0, 1, 2}, {0, 3, 4}});
  CHECK(cut({0, 1, 0, 1}).faces.empty());
  CHECK(cut({5, 5, 5, 5, 5}).faces.empty());
  CHECK(cut({0, 1, 2, 3, 2}).notes.back() ==
        "off: 1 polygon cut into loops where a corner is visited again");
}

TEST_CASE("loops have the oriented boundary of their polygon, and no face with equal corners") {
  test::Random random(7);
  for (int round = 0; round < 2000; ++round) {
    const std::size_t size = 4 + random.below(30);
    const std::size_t different = 2 + random.below(12);
    std::vector<Index> corners;
    for (std::size_t i = 0; i < size; ++i)
      corners.push_back(static_cast<Index>(random.below(different)));
    const std::vector<Face> faces = cut(corners).faces;
    CHECK(boundary_of(faces) == boundary_of(corners));
    CHECK(faces.size() + 2 <= size);
    CHECK(std::none_of(faces.begin(), faces.end(), is_collapsed));
  }
}
