// Laws of Boolean operations on random operands that intersect themselves, touch, coincide and
// contain each other, checked by solid angles; and cases with closed forms.
#include "transformesh/boolean.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

using Operation = BooleanOperation;

BooleanResult combine(Operation operation, const std::vector<Mesh>& meshes,
                      BooleanOptions options = {}) {
  std::vector<Operand> operands;
  for (const Mesh& mesh : meshes)
    operands.push_back({&mesh, "operand " + std::to_string(operands.size())});
  return boolean(operation, operands, options);
}

/// Returns a box or a tetrahedron. Its corners lie on a coarse grid before the rotation, so that
/// faces of parts with the same rotation are often coplanar.
Mesh random_part(test::Random& random, const Eigen::Matrix3d& rotation) {
  const auto steps = [&](std::uint64_t least, std::uint64_t below) {
    return static_cast<double>(least + random.below(below));
  };
  Mesh part = random.below(3) == 0 ? test::tetrahedron() : test::cube();
  const Vec3 size(steps(1, 3), steps(1, 3), steps(1, 3));
  const Vec3 at(steps(0, 4), steps(0, 4), steps(0, 4));
  for (Vec3& p : part.positions) p = rotation * (p.cwiseProduct(size) + at);
  return random.below(8) == 0 ? test::reversed(part) : part;
}

/// Returns up to three parts; some may be inside out.
Mesh random_operand(test::Random& random) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  if (random.below(3) == 0)
    rotation = Eigen::AngleAxisd(random.uniform(0, 3), random.point(-1, 1).normalized())
                   .toRotationMatrix();
  Mesh operand = random_part(random, rotation);
  for (std::uint64_t i = random.below(3); i > 0; --i)
    operand = test::joined(operand, random_part(random, rotation));
  if (random.below(5) == 0) {
    const Mesh speck = test::moved(test::scaled(test::cube(), 0.1), Vec3(1.33, 1.37, 1.41));
    operand = test::joined(operand, random.below(2) == 0 ? speck : test::reversed(speck));
  }
  return operand;
}

/// Returns up to four operands. Some are equal, empty, or inside of another one.
std::vector<Mesh> related_operands(test::Random& random) {
  std::vector<Mesh> operands;
  for (std::uint64_t i = 1 + random.below(4); i > 0; --i) {
    const std::uint64_t kind = operands.empty() ? 9 : random.below(10);
    if (kind == 0) {
      operands.push_back(operands.front());
    } else if (kind == 1) {
      operands.emplace_back();
    } else if (kind == 2) {
      const Vec3 at = operands.front().positions.front();
      operands.push_back(test::moved(test::scaled(test::moved(operands.front(), -at), 0.5), at));
    } else {
      operands.push_back(random_operand(random));
    }
  }
  return operands;
}

bool is_selected(Operation operation, const std::vector<int>& windings) {
  std::size_t inside = 0;
  for (const int winding : windings) inside += winding >= 1 ? 1 : 0;
  switch (operation) {
    case Operation::unite:
      return inside > 0;
    case Operation::intersect:
      return inside == windings.size();
    case Operation::subtract:
      return inside == 1 && windings[0] >= 1;
    case Operation::exclude:
      break;
  }
  return inside % 2 == 1;
}

/// Returns nothing for a point near the surface.
std::optional<int> winding_at(const Mesh& mesh, const Vec3& point) {
  const double winding = test::winding_number(mesh, point);
  if (std::abs(winding - std::round(winding)) > 1e-6) return std::nullopt;
  return static_cast<int>(std::round(winding));
}

void check_solid(const Mesh& mesh) {
  CHECK(find_intersections(mesh).empty());
  const test::Count count = test::count(mesh);
  CHECK(count.is_closed_and_oriented);
  CHECK(count.is_manifold);
}

void check_samples(Operation operation, const std::vector<Mesh>& operands, const Mesh& result,
                   test::Random& random) {
  for (int i = 0; i < 60; ++i) {
    const Vec3 point = random.point(-0.5, 6.5);
    std::vector<int> windings;
    for (const Mesh& operand : operands)
      if (const auto winding = winding_at(operand, point)) windings.push_back(*winding);
    const auto found = winding_at(result, point);
    if (windings.size() < operands.size() || !found) continue;
    CHECK(*found == (is_selected(operation, windings) ? 1 : 0));
  }
}

double area_of(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.faces)
    sum +=
        (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]).norm();
  return sum / 2;
}

std::uint64_t rounds() {
  const char* wanted = std::getenv("TM_ROUNDS");
  return wanted != nullptr ? static_cast<std::uint64_t>(std::atoi(wanted)) : 1;
}

}  // namespace

TEST_CASE("Boolean operations agree with winding numbers: 100 cases, TM_ROUNDS=20 for 2000") {
  for (std::uint64_t seed = 0; seed < 25 * rounds(); ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<Mesh> operands;
    for (std::uint64_t i = 1 + random.below(4); i > 0; --i)
      operands.push_back(random_operand(random));
    if (operands.size() > 1 && random.below(6) == 0) operands.back() = operands.front();
    for (const Operation operation :
         {Operation::unite, Operation::intersect, Operation::subtract, Operation::exclude}) {
      CAPTURE(static_cast<int>(operation));
      const Mesh result = combine(operation, operands).mesh;
      check_solid(result);
      check_samples(operation, operands, result, random);
    }
  }
}

TEST_CASE("volumes obey the laws of sets: 10 cases of up to 4 operands, TM_ROUNDS=200 for 2000") {
  for (std::uint64_t seed = 0; seed < 10 * rounds(); ++seed) {
    CAPTURE(seed);
    test::Random random(1000 + seed);
    const std::vector<Mesh> operands = related_operands(random);
    const auto volume = [](Operation operation, const std::vector<Mesh>& meshes) {
      return test::signed_volume(combine(operation, meshes).mesh);
    };
    // The error of 1e-9 is relative to 1 or to the volume; rounding of coordinates causes 1e-13.
    const auto near = [](double value) { return doctest::Approx(value).epsilon(1e-9); };
    double united = 0, odd = 0;
    for (std::size_t set = 1; set < std::size_t{1} << operands.size(); ++set) {
      std::vector<Mesh> chosen;
      for (std::size_t i = 0; i < operands.size(); ++i)
        if ((set >> i & 1) != 0) chosen.push_back(operands[i]);
      const double part = volume(Operation::intersect, chosen);
      united += chosen.size() % 2 == 1 ? part : -part;
      odd += std::pow(-2, static_cast<double>(chosen.size() - 1)) * part;
    }
    CHECK(volume(Operation::unite, operands) == near(united));
    CHECK(volume(Operation::exclude, operands) == near(odd));

    const Mesh all = test::cuboid(Vec3::Constant(-20), Vec3::Constant(20));
    std::vector<Mesh> all_and{all}, complements;
    for (const Mesh& operand : operands) {
      all_and.push_back(operand);
      complements.push_back(combine(Operation::subtract, {all, operand}).mesh);
    }
    const double size = test::signed_volume(all);
    CHECK(volume(Operation::subtract, all_and) == near(size - united));
    CHECK(volume(Operation::intersect, complements) == near(size - united));
    CHECK(volume(Operation::unite, complements) ==
          near(size - volume(Operation::intersect, operands)));
    CHECK(volume(Operation::exclude, complements) ==
          near(operands.size() % 2 == 0 ? odd : size - odd));
  }
}

TEST_CASE("a body inside another is cut out, and one inside out is empty") {
  const Mesh large = test::cuboid(Vec3::Zero(), Vec3::Constant(3));
  const Mesh small = test::moved(test::cube(), Vec3::Ones());
  CHECK(test::signed_volume(combine(Operation::exclude, {large, small}).mesh) == 26);
  CHECK(test::signed_volume(combine(Operation::exclude, {small, large}).mesh) == 26);
  CHECK(test::signed_volume(combine(Operation::subtract, {large, small}).mesh) == 26);
  CHECK(combine(Operation::subtract, {small, large}).mesh.faces.empty());
  const BooleanResult nothing = combine(Operation::unite, {test::reversed(large)});
  CHECK(nothing.mesh.faces.empty());
  CHECK(nothing.inside_out == std::vector<std::size_t>{0});
  CHECK(combine(Operation::subtract, {large, test::reversed(small)}).inside_out ==
        std::vector<std::size_t>{1});
  CHECK(combine(Operation::subtract, {small, large, Mesh{}}).inside_out.empty());
  const Mesh both_sides = test::joined(small, test::reversed(small));
  CHECK(combine(Operation::subtract, {large, both_sides}).canceling == std::vector<std::size_t>{1});
  CHECK(combine(Operation::unite, {both_sides}).canceling == std::vector<std::size_t>{0});
  CHECK(test::signed_volume(combine(Operation::subtract, {large, test::reversed(small)}).mesh) ==
        27);
}

TEST_CASE("disjoint operands pass unchanged") {
  const Mesh first = test::icosphere(2), second = test::moved(first, Vec3(5, 0, 0));
  const CleanResult result = combine(Operation::unite, {first, second});
  const Mesh both = test::joined(first, second);
  CHECK(result.mesh.positions == both.positions);
  CHECK(result.mesh.faces == both.faces);
}

TEST_CASE("open operands are refused, and empty ones allowed") {
  Mesh open = test::cube();
  open.faces.pop_back();
  CHECK_THROWS_WITH_AS(combine(Operation::unite, {test::cube(), open}),
                       "operand 1 has 1 border: it is not a solid", InputError);
  CHECK(combine(Operation::unite, {Mesh{}, Mesh{}}).mesh.faces.empty());
  CHECK(combine(Operation::intersect, {test::cube(), Mesh{}}).mesh.faces.empty());
  CHECK(combine(Operation::subtract, {test::cube(), Mesh{}}).mesh.faces.size() == 12);
}

TEST_CASE("the column source_operand names the operand of each face") {
  const Mesh small = test::moved(test::cube(), Vec3::Constant(0.5));
  for (const Operation operation : {Operation::subtract, Operation::exclude}) {
    BooleanOptions options;
    options.source_operand = true;
    const Mesh result = combine(operation, {test::cube(), small}, options).mesh;
    const Column& operand = *result.face_columns.find("source_operand");
    std::array<double, 2> area{};
    for (std::size_t f = 0; f < result.faces.size(); ++f) {
      const auto& [a, b, c] = result.faces[f];
      const auto& p = result.positions;
      area[operand.values[f] == 0 ? 0 : 1] += (p[b] - p[a]).cross(p[c] - p[a]).norm() / 2;
    }
    CHECK(area[0] == doctest::Approx(operation == Operation::subtract ? 5.25 : 6));
    CHECK(area[1] == doctest::Approx(operation == Operation::subtract ? 0.75 : 6));
  }
}

TEST_CASE("a sheet is cut by the surface of a solid") {
  Mesh sheet = test::moved(test::scaled(test::grid(3), 4), Vec3(-1, -1, 0.5));
  const Mesh cube = test::cuboid(Vec3::Zero(), Vec3(2, 2, 1));
  const auto area = [&](SheetSide side) {
    return area_of(cut_sheet({&sheet, "sheet"}, {&cube, "cube"}, side).mesh);
  };
  CHECK(area(SheetSide::inside) == doctest::Approx(4));
  CHECK(area(SheetSide::outside) == doctest::Approx(12));
  for (Vec3& p : sheet.positions) p.z() = 3;
  CHECK(area(SheetSide::inside) == 0);
  CHECK(area(SheetSide::outside) == doctest::Approx(16));
}
