#include "boolean/operand_kinds.h"

#include <doctest/doctest.h>

#include "clean/intersect/contacts.h"
#include "helpers/shapes.h"

using namespace transformesh;

namespace {

using Kind = OperandKind;

std::vector<Kind> kinds_of(BooleanOperation operation, const std::vector<Mesh>& meshes) {
  std::vector<Operand> operands;
  for (const Mesh& mesh : meshes) operands.push_back({&mesh});
  const JoinedOperands joined = join_operands(operation, operands);
  const WeldedMesh welded = weld(joined.mesh);
  return find_operand_kinds(welded, find_meetings(welded, Progress()), joined);
}

Kind kind_of(const Mesh& mesh) {
  const Kind kind = kinds_of(BooleanOperation::unite, {mesh})[0];
  // The kind depends on the mesh alone, not on its orientation or on other operands.
  const Mesh other = test::moved(test::cube(), Vec3::Constant(0.4));
  CHECK(kinds_of(BooleanOperation::unite, {other, mesh})[1] == kind);
  CHECK(kinds_of(BooleanOperation::subtract, {other, mesh})[1] == kind);
  CHECK(kinds_of(BooleanOperation::subtract, {mesh, mesh})[0] == kind);
  CHECK(kinds_of(BooleanOperation::subtract, {mesh, mesh})[1] == kind);
  return kind;
}

}  // namespace

TEST_CASE("simple, not negative and unknown operands are distinguished") {
  const Mesh cube = test::cube();
  const Mesh apart = test::moved(cube, Vec3(3, 0, 0));
  const Mesh across = test::moved(cube, Vec3(0.5, 0.25, 0.125));
  const Mesh within = test::moved(test::scaled(cube, 0.5), Vec3::Constant(0.25));
  const Mesh beside_edge = test::moved(cube, Vec3(1, 1, 0));
  CHECK(kind_of(cube) == Kind::simple);
  CHECK(kind_of(test::joined(cube, apart)) == Kind::simple);
  CHECK(kind_of(test::joined(cube, test::reversed(within))) == Kind::simple);
  CHECK(kind_of(test::joined(cube, beside_edge)) == Kind::simple);
  CHECK(kind_of(test::joined(cube, within)) == Kind::not_negative);
  CHECK(kind_of(test::joined(cube, across)) == Kind::not_negative);
  CHECK(kind_of(test::reversed(cube)) == Kind::unknown);
  CHECK(kind_of(test::joined(cube, test::reversed(apart))) == Kind::unknown);
  CHECK(kind_of(test::joined(cube, test::reversed(across))) == Kind::unknown);
  CHECK(kind_of(test::joined(cube, cube)) == Kind::unknown);
  Mesh open = cube;
  open.faces.pop_back();
  CHECK(kind_of(open) == Kind::unknown);
}

TEST_CASE("an operand that intersects itself is unknown") {
  Mesh torn = test::icosphere(2);
  torn.positions[0] = -1.5 * torn.positions[0];
  CHECK(kind_of(torn) == Kind::unknown);
}
