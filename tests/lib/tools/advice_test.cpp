#include "frame/advice.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

#include "frame/program.h"

using namespace transformesh;
using namespace transformesh::tool;

namespace {

Program program_with(const std::vector<std::string>& flags) {
  static bool value = false;
  Program program{"tm-x", "", ""};
  for (const std::string& name : flags) program.options.flag(name, &value, "");
  return program;
}

std::string advice(ErrorKind kind, const std::vector<std::string>& flags, ErrorData data = {}) {
  return advice_for({kind, "", std::move(data)}, program_with(flags));
}

}  // namespace

TEST_CASE("every kind has a remedy, unless none is known") {
  const std::set<ErrorKind> without = {ErrorKind::other, ErrorKind::no_such_level,
                                       ErrorKind::coordinates_too_large, ErrorKind::unknown_format};
  std::set<ErrorKind> kinds;
  for (const Advice& row : advice_table()) kinds.insert(row.kind);
  for (int i = 0; i <= static_cast<int>(ErrorKind::not_a_run); ++i) {
    const auto kind = static_cast<ErrorKind>(i);
    CAPTURE(name_of(kind));
    CHECK(kinds.contains(kind) != without.contains(kind));
  }
}

TEST_CASE("a remedy for all programs is the last one of its kind") {
  std::set<ErrorKind> ended;
  for (const Advice& row : advice_table()) {
    CAPTURE(row.text);
    CHECK_FALSE(ended.contains(row.kind));
    if (*row.option == 0) ended.insert(row.kind);
  }
}

TEST_CASE("programs offer no options that they do not have") {
  CHECK(advice(ErrorKind::component_too_small, {"min-edge"}) == "use a smaller --min-edge");
  CHECK(advice(ErrorKind::component_too_small, {}).empty());
  CHECK(
      advice(ErrorKind::float_rounding_failed, {"double"}).starts_with("write doubles (--double)"));
  CHECK(advice(ErrorKind::float_rounding_failed, {}).find("tm-convert --double") !=
        std::string::npos);
  CHECK(advice(ErrorKind::other, {"double"}).empty());
}

TEST_CASE("the remedy follows the sentence, and contains data of the problem") {
  const Program program = program_with({"reference-edge"});
  CHECK(with_advice({ErrorKind::not_closed, "the mesh is open"}, program) ==
        "the mesh is open; close holes with tm-fill");
  CHECK(with_advice({ErrorKind::other, "the mesh is odd"}, program) == "the mesh is odd");
  CHECK(advice(ErrorKind::not_a_run, {}, {.name = "folder"}).ends_with("--run folder"));
  // The longest edges are 1.5 times as long as the reference edge, and half of the reference edge
  // is offered.
  CHECK(advice(ErrorKind::edges_too_long, {"reference-edge"}, {.lengths = {0.01, 0.3}}) ==
        "shorten edges with --reference-edge 0.1");
}
