#include "command.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "tm/support/error.h"

using namespace transformesh;
using namespace transformesh::tool;

namespace {

// What follows the name and the version.
std::string options_of(const Command& command) {
  const std::string line = provenance(command);
  return line.substr(std::min(line.size(), line.find(' ', line.find(' ') + 1)));
}

}  // namespace

TEST_CASE("provenance holds the words and options given that affect the result") {
  Length edge{0.7, Length::Unit::reference_edge};
  std::string target;
  std::string axis = "z";
  bool keep = false;
  bool quiet = false;
  std::vector<std::string> words;
  Program program("tm-remesh", "", "");
  program.length("min-edge", &edge, "");
  program.text("target", &target, "FILE", "");
  program.text("axis", &axis, "AXIS", "");
  program.flag("keep-border", &keep, "");
  program.flag("again", &quiet, "");
  program.keep_out_of_provenance("again");
  Command& command = program.command();
  CHECK(options_of(command) == "");
  command.parse({"--keep-border", "--min-edge", "0.70x", "--target", "t.ply", "--again"});
  command.assign();
  words = {"torus-knot", "2"};
  command.words = &words;
  CHECK(options_of(command) == " torus-knot 2 --min-edge 0.7x --keep-border");
  axis = "a b\nend_header";
  command.parse({"--axis", axis});
  CHECK(options_of(command).ends_with("--axis 'a b?end_header' --keep-border"));
}

TEST_CASE("what is needed is asked for with what it is for") {
  std::string target;
  Program program("tm-x", "", "");
  program.text("target", &target, "FILE", "mesh to move towards");
  program.require("target");
  CHECK(program.command().parse({"word"}) == std::vector<std::string>{"word"});
  try {
    program.command().assign();
    FAIL("not refused");
  } catch (const UsageError& error) {
    CHECK(std::string(error.what()) == "--target FILE is needed: mesh to move towards");
  }
  program.command().parse({"--target", "t.ply"});
  program.command().assign();
  CHECK(target == "t.ply");
}

TEST_CASE("short names") {
  std::string output;
  bool quiet = false;
  Program program("tm-x", "", "");
  program.text("output,o", &output, "FILE", "");
  program.flag("quiet,q", &quiet, "");
  program.command().parse({"-qo", "a.ply"});
  program.command().assign();
  CHECK(quiet);
  CHECK(output == "a.ply");
}

TEST_CASE("the reference edge is auto or a positive length") {
  const auto parse = [](const std::string& value) {
    Program program("tm-x", "", "");
    program.reference_edge("auto", "");
    program.command().parse({"--reference-edge", value});
  };
  CHECK_NOTHROW(parse("auto"));
  CHECK_NOTHROW(parse("0.5%"));
  CHECK_THROWS_AS(parse("0"), UsageError);
  CHECK_THROWS_AS(parse("often"), UsageError);
}
