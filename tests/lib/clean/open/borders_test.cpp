#include "clean/open/borders.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "clean/stitch/orientation_check.h"
#include "helpers/mesh_facts.h"
#include "helpers/shapes.h"
#include "transformesh/clean.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "transformesh/stitch.h"

using namespace transformesh;

namespace {

Borders borders_of(const Mesh& mesh) { return find_borders(weld(mesh), mesh); }

std::string refusal(const Mesh& mesh) {
  try {
    clean(mesh);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Adds a parallelogram with sides u and v at the first corner.
void add_square(Mesh& mesh, const Vec3& corner, const Vec3& u, const Vec3& v) {
  const auto base = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {corner, corner + u, corner + u + v, corner + v});
  mesh.faces.insert(mesh.faces.end(), {{base, base + 1, base + 2}, {base, base + 2, base + 3}});
}

/// Three faces around the edge from vertex 0 to vertex 1, of which two traverse it forward and one
/// backward.
Mesh fan_of_three() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 2, 0}, {-1, -2, 0}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}};
  return mesh;
}

/// The open body with x, y, z > 0 and 1 < x + y + z < size, without its face at x + y + z = 1.
Mesh body_with_open_corner(double size) {
  Mesh mesh;
  mesh.positions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
  mesh.faces = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}, {3, 4, 5}};
  return mesh;
}

}  // namespace

TEST_CASE("a closed chain of faces has no borders, whatever its indices") {
  const Mesh edge = test::joined(test::cube(), test::moved(test::cube(), {1, 1, 0}));
  for (const Mesh& mesh : {test::cube(), edge, test::joined(test::cube(), test::cube()),
                           test::joined(test::cube(), test::reversed(test::cube()))}) {
    Mesh soup;
    for (const Face& face : mesh.faces) {
      for (const Index v : face) soup.positions.push_back(mesh.positions[v]);
      const auto last = static_cast<Index>(soup.positions.size());
      soup.faces.push_back({last - 3, last - 2, last - 1});
    }
    for (const Mesh& each : {mesh, soup}) {
      CHECK(borders_of(each).is_oriented);
      CHECK(borders_of(each).loops.empty());
      CHECK(describe_misorientation(each).empty());
    }
  }
}

TEST_CASE("the border of an open mesh is a loop along its faces") {
  const Mesh mesh = test::grid(5);
  const WeldedMesh welded = weld(mesh);
  const Borders borders = find_borders(welded, mesh);
  CHECK(borders.is_oriented);
  REQUIRE(borders.loops.size() == 1);
  const std::vector<Index>& loop = borders.loops[0];
  REQUIRE(loop.size() == 20);
  // Counterclockwise, so the shoelace formula gives a positive area: one.
  double area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 &a = welded.points[loop[i]], &b = welded.points[loop[(i + 1) % loop.size()]];
    CHECK((b - a).norm() == doctest::Approx(0.2));
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  CHECK(std::abs(area) == doctest::Approx(1));
  CHECK(area * (mesh.positions[mesh.faces[0][1]] - mesh.positions[mesh.faces[0][0]])
                   .cross(mesh.positions[mesh.faces[0][2]] - mesh.positions[mesh.faces[0][0]])
                   .z() >
        0);
}

TEST_CASE("a sheet that ends on a surface has its border there") {
  Mesh mesh = test::cube();
  add_square(mesh, {0, 0, 1}, Vec3::UnitX(), Vec3::UnitZ());
  const Borders borders = borders_of(mesh);
  CHECK(borders.is_oriented);
  REQUIRE(borders.loops.size() == 1);
  CHECK(borders.loops[0].size() == 4);
}

TEST_CASE("faces that name a point twice say nothing about orientation") {
  Mesh mesh = test::grid(2);
  mesh.positions.push_back(mesh.positions[0]);
  const auto twin = static_cast<Index>(mesh.positions.size() - 1);
  for (int i = 0; i < 3; ++i) mesh.faces.push_back({0, twin, 1});
  const Borders borders = borders_of(mesh);
  CHECK(borders.is_oriented);
  REQUIRE(borders.loops.size() == 1);
  CHECK(borders.loops[0].size() == 8);
  CHECK(test::signed_volume(clean(mesh).mesh) == 0);
}

TEST_CASE("refused: a reversed face; the error names two faces and the remedy") {
  Mesh mesh = test::icosphere(1);
  std::swap(mesh.faces[7][0], mesh.faces[7][1]);
  const std::string message = refusal(mesh);
  CAPTURE(message);
  unsigned first = 0, second = 0, from = 0, to = 0;
  double x = 0, y = 0, z = 0;
  REQUIRE(std::sscanf(message.c_str(),
                      "faces %u and %u traverse the edge from vertex %u at (%lf, "
                      "%lf, %lf) to vertex %u at (",
                      &first, &second, &from, &x, &y, &z, &to) == 7);
  for (const unsigned f : {first, second}) {
    const Face& face = mesh.faces[f];
    const auto at = std::find(face.begin(), face.end(), from);
    REQUIRE(at != face.end());
    CHECK(face[static_cast<std::size_t>(at - face.begin() + 1) % 3] == to);
  }
  CHECK(mesh.positions[from] == Vec3(x, y, z));
  CHECK(message.ends_with("(the first of 3 such edges): the mesh is not oriented"));
  StitchOptions options;
  options.orient = true;
  stitch(mesh, options);
  CHECK(refusal(mesh).empty());
}

TEST_CASE("two bodies may end at the same border, but not with a reversed part") {
  const Mesh two = test::joined(body_with_open_corner(2), body_with_open_corner(3));
  CHECK(refusal(two).empty());
  CHECK(surface_area(clean(two).mesh) ==
        doctest::Approx(surface_area(body_with_open_corner(3))).epsilon(1e-12));

  // A flat pyramid with a reversed base: all faces meet the base at small angles.
  Mesh pyramid = test::tetrahedron();
  pyramid.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 0.01}};
  for (Face& face : pyramid.faces)
    if (std::find(face.begin(), face.end(), 3) == face.end()) std::swap(face[0], face[1]);
  Mesh base = pyramid;
  std::erase_if(base.faces,
                [](const Face& f) { return std::find(f.begin(), f.end(), 3) != f.end(); });
  std::erase_if(pyramid.faces,
                [](const Face& f) { return std::find(f.begin(), f.end(), 3) == f.end(); });
  CHECK(refusal(test::joined(pyramid, base)).ends_with(": the mesh is not oriented"));
}

TEST_CASE("refused: an edge with more than one face left over") {
  Mesh mesh = fan_of_three();
  CHECK(refusal(mesh).empty());
  std::swap(mesh.faces[2][0], mesh.faces[2][1]);
  mesh.positions.push_back(mesh.positions[1]);
  mesh.faces.push_back({0, 1, 5});  // has no area, and is not named
  CHECK(refusal(mesh) ==
        "faces 0, 1 and 2 traverse the edge from vertex 0 at (0, 0, 0) to vertex 1 "
        "at (0, 0, 1) in the same direction: the mesh is not oriented");
}

TEST_CASE("refused: a non-orientable mesh has its own kind of error") {
  Mesh strip = test::moebius_strip(12);
  CHECK(refusal(strip).ends_with(": the surface has only one side, like a Moebius strip"));

  // A solid with an edge on the strip: four faces now meet there, and three of them always traverse
  // the edge in the same direction.
  const Vec3 a = strip.positions[0], b = strip.positions[1];
  const auto base = static_cast<Index>(strip.positions.size());
  strip.positions.insert(strip.positions.end(), {a, b, a + Vec3(3, 0, 0), a + Vec3(3, 1, 1)});
  for (const Face& f : test::tetrahedron().faces) {
    strip.faces.push_back({f[0] + base, f[1] + base, f[2] + base});
  }
  const std::string message = refusal(strip);
  CAPTURE(message);
  CHECK(message.starts_with("faces "));
  CHECK(message.find(" traverse the edge from vertex ") != std::string::npos);
  CHECK(message.ends_with(
      ", and only 1 in the opposite direction, and reversing connected parts cannot change that"));
  StitchOptions options;
  options.orient = true;
  Mesh apart = strip;
  CHECK_FALSE(stitch(apart).can_be_oriented);
  CHECK(refusal(apart).empty());
  const StitchResult result = stitch(strip, options);
  CHECK(result.misoriented_edges == 1);
  CHECK(message.starts_with(result.misorientation));
}
