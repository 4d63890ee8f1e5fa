#include "frame/run_report.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "helpers/shapes.h"

using namespace transformesh;
using namespace transformesh::tool;

namespace {

struct Place {
  Terminal terminal{"tm-x"};
  Program program{"tm-x", "[INPUT]", "Tests", {Reads::mesh}, {Writes::report}};
  Messages messages{program, terminal};
  Phases phases;
  Inputs inputs{program, messages, phases};
  RunReport report{program, inputs, messages};
};

}  // namespace

TEST_CASE("entries are printed as lines, as JSON, or singly") {
  Place place;
  place.report.add("closed", true);
  place.report.add({{"faces", std::size_t{12}}, {"box", std::vector<double>{0, .5}}});
  CHECK(place.report.text() == "closed: true\nfaces: 12\nbox: 0 0.5\n");
  const std::string key = "faces";
  place.program.output.only_key = &key;
  CHECK(place.report.text() == "12\n");
  place.program.output.only_key = nullptr;
  place.program.common.json = true;
  CHECK(Json::parse(place.report.text()) ==
        Json{{"closed", true}, {"faces", 12}, {"box", {0, .5}}});
}

TEST_CASE("the full report resolves lengths and leaves out common options not given") {
  Place place;
  Length length{.5, Length::Unit::diagonal};
  bool flag = false;
  place.program.options.length("min-edge", &length, "a length");
  place.program.options.flag("quiet", &flag, "common").is_common = true;
  place.inputs.set_basis(8);
  place.report.add("moved", std::size_t{3});
  const Json full = Json::parse(place.report.full({{"faces", std::size_t{7}}}, place.phases));
  CHECK(full["tool"] == "tm-x");
  CHECK(full["options"] == Json{{"min_edge", 4}});
  CHECK(full["output"] == Json{{"faces", 7}});
  CHECK(full["result"] == Json{{"moved", 3}});
  CHECK(!full.contains("input"));
  CHECK(full["timings"].contains("total"));
  CHECK(full["peak_memory_bytes"] > 0);
}
