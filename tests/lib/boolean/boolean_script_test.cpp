#include "boolean/boolean_script.h"

#include <doctest/doctest.h>

#include "helpers/mesh_facts.h"
#include "helpers/shapes.h"
#include "mesh/coordinate_spacing.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

void check_refused(const char* text, const char* message) {
  CAPTURE(text);
  CHECK_THROWS_WITH_AS(parse_boolean_script(text), message, InputError);
}

}  // namespace

TEST_CASE("a script is parsed line by line") {
  const auto lines = parse_boolean_script(
      "# first\r\n\na = union b.ply \"the c.ply\"  # more\n\tx#y\t= xor  a \"\"\r\nz = difference "
      "a");
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].number == 3);
  CHECK(lines[0].result == "a");
  CHECK(lines[0].operation == BooleanOperation::unite);
  CHECK(lines[0].operands == std::vector<std::string>{"b.ply", "the c.ply"});
  CHECK(lines[1].result == "x#y");
  CHECK(lines[1].operation == BooleanOperation::exclude);
  CHECK(lines[1].operands == std::vector<std::string>{"a", ""});
  CHECK(lines[2].number == 5);
}

TEST_CASE("malformed lines of a script are refused") {
  check_refused("", "the script has no line with an operation");
  check_refused("# a\n\n", "the script has no line with an operation");
  check_refused("a = union", "line 1 of the script: expected NAME = OPERATION OPERAND...");
  check_refused("a b union c", "line 1 of the script: expected NAME = OPERATION OPERAND...");
  check_refused("\na = \"union c", "line 2 of the script: a quote is not closed");
  check_refused("a = diference c",
                "line 1 of the script: unknown operation 'diference'; did you mean 'difference'?");
}

TEST_CASE("results are operands of later lines, and files are read when they are needed") {
  std::vector<std::string> files;
  const auto read = [&](const std::string& file) {
    files.push_back(file);
    return test::moved(test::cube(), Vec3(std::stod(file), 0, 0));
  };
  const auto lines = parse_boolean_script(
      "a = union 0 0.5\nb = difference a 0.25\na = union b 0.25\na = xor a 0 5\n");
  const ScriptResult result = run_boolean_script(lines, read, {}, Progress());
  CHECK(files == std::vector<std::string>{"0", "0.5", "0.25", "5"});
  CHECK(test::signed_volume(result.mesh) == doctest::Approx(1.5));
  CHECK(result.pairs > 0);
}

TEST_CASE("operands of doubles are rounded first if the result is stored as float") {
  const auto read = [](const std::string& file) {
    return test::moved(test::icosphere(3), Vec3(std::stod(file), 0.01, 0.02));
  };
  const auto lines = parse_boolean_script(
      "a = union 100 100.3\na = union a 100.1\na = difference a 100.9\nb = intersection a 100.2\n");
  const ScriptResult result =
      run_boolean_script(lines, read, {.coordinate = Scalar::float32}, Progress());
  CHECK(!rounded_mesh(result.mesh, Scalar::float32));
  CHECK(find_intersections(result.mesh).empty());
  CHECK(test::signed_volume(result.mesh) > 1);
}

TEST_CASE("an error names its line") {
  Mesh open = test::cube();
  open.faces.pop_back();
  const auto read = [&](const std::string&) { return open; };
  CHECK_THROWS_WITH_AS(
      run_boolean_script(parse_boolean_script("\na = union x"), read, {}, Progress()),
      "line 2 of the script: x has 1 border: it is not a solid", InputError);
}
