/// Merging of close vertices: by distances of their own places, and what is at one position stays
/// at one position.
#include "clean/rounding/close_vertices.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/assembly_of.h"

namespace transformesh {
namespace {

/// Separate faces, each with one corner at a position named; all is new.
Assembly faces_at(const std::vector<Vec3>& corners) {
  Assembly assembly;
  for (const Vec3& corner : corners) {
    const auto first = static_cast<Index>(assembly.mesh.positions.size());
    const double i = first;
    assembly.mesh.positions.insert(assembly.mesh.positions.end(),
                                   {corner, Vec3(7 + i, 1, 0), Vec3(5, 7 + i, 1)});
    assembly.mesh.faces.push_back({first, first + 1, first + 2});
    assembly.source_face.push_back(first / 3);
  }
  assembly.vertex_is_new.assign(assembly.mesh.positions.size(), 1);
  assembly.face_is_new.assign(corners.size(), 1);
  return assembly;
}

Displacement merge(Assembly& assembly, const MoveRule& rule) {
  return merge_close_vertices(assembly, test::all_faces(assembly.mesh), rule, {Scalar::float64});
}

const double spacing_at_one = 0x1p-52;

}  // namespace

TEST_CASE("along the axis of a far coordinate only what is close along the others merges") {
  // Faces that lead from 2^60 to near the origin along x: along y and z, ones are far apart.
  Assembly assembly;
  const Vec3 place(0x1p60, 1, 1);
  const std::vector<Vec3> seconds = {Vec3(0x1p60, 2, 1), place + Vec3(512, 0x1p-45, 0)};
  for (const Vec3& corner : {place, seconds[0], seconds[1]}) {
    const auto first = static_cast<Index>(assembly.mesh.positions.size());
    const double i = first;
    for (const Vec3& p : {corner, Vec3(i, 1, 0.5), Vec3(0, 1.5, 1 + i)})
      assembly.mesh.positions.push_back(p);
    assembly.mesh.faces.push_back({first, first + 1, first + 2});
    assembly.source_face.push_back(first / 3);
  }
  assembly.vertex_is_new.assign(9, 1);
  assembly.face_is_new.assign(3, 1);
  Assembly by_largest = assembly;

  merge(assembly, {4, false});
  CHECK(assembly.mesh.positions[3] == seconds[0]);
  CHECK(assembly.mesh.positions[6] == place);
  merge_close_vertices(by_largest, test::all_faces(by_largest.mesh), {4, false},
                       {Scalar::float64, false});
  CHECK(by_largest.mesh.positions[3] == place);
}

TEST_CASE("vertices closer than the rule merge, those farther apart stay") {
  const Vec3 place(1.5, 1.25, -1.125);
  Assembly assembly = faces_at(
      {place, place + Vec3(2 * spacing_at_one, 0, 0), place + Vec3(0, 8 * spacing_at_one, 0)});
  const Displacement moved = merge(assembly, {4, false});
  CHECK(assembly.mesh.positions[0] == assembly.mesh.positions[3]);
  CHECK(assembly.mesh.positions[6] == place + Vec3(0, 8 * spacing_at_one, 0));
  CHECK(moved.spacings == doctest::Approx(2));
  CHECK(moved.length == doctest::Approx(2 * spacing_at_one));
}

TEST_CASE("a far vertex does not coarsen what is near the origin") {
  const Vec3 place(1.5, 1.25, -1.125);
  const Vec3 beside = place + Vec3(1e-9, 0, 0);
  Assembly assembly = faces_at({place, beside, Vec3(1e30, 1, 1), Vec3(1e30, 1e6, 1)});
  merge_close_vertices(assembly, test::all_faces(assembly.mesh), {4, false},
                       {Scalar::float64, false});
  CHECK(assembly.mesh.positions[0] == place);
  CHECK(assembly.mesh.positions[3] == beside);
  CHECK(assembly.mesh.positions[6] == assembly.mesh.positions[9]);
}

TEST_CASE("neighbors are found across a power of two and across cells") {
  for (int exponent = -20; exponent <= 20; ++exponent) {
    const double x = std::ldexp(1.0, exponent);
    const double below = x - spacing_at(x / 2), above = x + 2 * spacing_at(x);
    Assembly assembly = faces_at({Vec3(below, 0, 0), Vec3(above, 0, 0)});
    merge(assembly, {4, false});
    CHECK(assembly.mesh.positions[0] == assembly.mesh.positions[3]);
  }
}

TEST_CASE("input vertices attract new ones, and move only if the rule says so") {
  const Vec3 place(1.5, 1.25, -1.125), beside = place - Vec3(spacing_at_one, 0, 0);
  for (const bool moves_input : {false, true}) {
    Assembly assembly = faces_at({beside, place, place + Vec3(spacing_at_one, 0, 0)});
    assembly.vertex_is_new[3] = assembly.vertex_is_new[6] = 0;
    merge(assembly, {4, moves_input});
    CHECK(assembly.mesh.positions[0] == place);
    CHECK(assembly.mesh.positions[3] == place);
    CHECK((assembly.mesh.positions[6] == place) == moves_input);
    CHECK((assembly.vertex_is_new[6] == 1) == moves_input);
  }
}

TEST_CASE("merging moves all vertices at a position, though only one belongs to the faces named") {
  const Vec3 place(1.5, 1.25, -1.125), beside = place + Vec3(spacing_at_one, 0, 0);
  Assembly assembly = faces_at({place, beside, beside});
  assembly.face_is_new[2] = 0;
  merge_close_vertices(assembly, {0, 1}, {4, false}, {Scalar::float64});
  CHECK(assembly.mesh.positions[3] == place);
  CHECK(assembly.mesh.positions[6] == place);
  CHECK(assembly.face_is_new[2] == 1);
}

TEST_CASE("spacings are those of the type") {
  const Vec3 place(1.5, 1.25, -1.125), beside = place + Vec3(0x1p-23, 0, 0);
  for (const Scalar type : {Scalar::float32, Scalar::float64}) {
    Assembly assembly = faces_at({place, beside});
    merge_close_vertices(assembly, {0, 1}, {4, false}, {type});
    CHECK((assembly.mesh.positions[3] == place) == (type == Scalar::float32));
  }
}

}  // namespace transformesh
