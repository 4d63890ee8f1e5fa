#include <doctest/doctest.h>

#include <algorithm>

#include "frame/program.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::tool;

namespace {

// Returns the provenance without the name and the version.
std::string options_of(const Program& program) {
  const std::string line = provenance(program);
  return line.substr(std::min(line.size(), line.find(' ', line.find(' ') + 1)));
}

}  // namespace

TEST_CASE("provenance holds the words and options given that affect the result") {
  Length edge{0.7, Length::Unit::reference_edge};
  std::string target;
  std::string axis = "z";
  bool keep = false;
  bool quiet = false;
  Program program{"tm-remesh", "", "", {Reads::words}};
  program.options.length("min-edge", &edge, "");
  program.options.text("target", &target, "FILE", "");
  program.options.text("axis", &axis, "AXIS", "");
  program.options.flag("keep-border", &keep, "");
  program.options.flag("again", &quiet, "").affects_result = false;
  CHECK(options_of(program) == "");
  program.options.parse({"--keep-border", "--min-edge", "0.70x", "--target", "t.ply", "--again"});
  program.inputs = {"torus-knot", "2"};
  CHECK(options_of(program) == " torus-knot 2 --min-edge 0.7x --keep-border");
  axis = "a b\nend_header";
  program.options.parse({"--axis", axis});
  CHECK(options_of(program).ends_with("--axis 'a b?end_header' --keep-border"));
}

TEST_CASE("short names") {
  std::string output;
  bool quiet = false;
  Program program{"tm-x", "", ""};
  program.options.text("output,o", &output, "FILE", "");
  program.options.flag("quiet,q", &quiet, "");
  program.options.parse({"-qo", "a.ply"});
  CHECK(quiet);
  CHECK(output == "a.ply");
}

TEST_CASE("the reference edge is auto or a positive length") {
  const auto parse = [](const std::string& value) {
    Program program{"tm-x", "", ""};
    program.reference_edge();
    program.options.parse({"--reference-edge", value});
  };
  CHECK_NOTHROW(parse("auto"));
  CHECK_NOTHROW(parse("0.5%"));
  CHECK_THROWS_AS(parse("0"), UsageError);
  CHECK_THROWS_AS(parse("often"), UsageError);
}
