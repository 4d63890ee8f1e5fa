#include "report.h"

#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "phases.h"

using namespace transformesh::tool;

TEST_CASE("a report keeps its order, as lines and as JSON") {
  Report report;
  report.set("volume", 0.1);
  report.set("faces", 12L);
  report.set("closed", true);
  report.set("problem", std::string("none"));
  report.set("bbox_min", std::vector<double>{0, -1.5, 1e-20});
  report.set("faces", 14L);
  CHECK(report.lines() ==
        "volume: 0.1\nfaces: 14\nclosed: true\nproblem: none\nbbox_min: 0 -1.5 1e-20\n");
  CHECK(report.json().dump() ==
        R"({"volume":0.1,"faces":14,"closed":true,"problem":"none","bbox_min":[0.0,-1.5,1e-20]})");
  CHECK(report.find("nothing") == nullptr);
}

TEST_CASE("JSON stays valid for numbers that it lacks and bytes that are no text") {
  Report report;
  report.set("mean", std::nan(""));
  report.set("name", std::string("a\xff\"b"));
  const std::string text = json_text(report.json());
  CHECK(nlohmann::json::accept(text));
  CHECK(text.find("\"mean\": null") != std::string::npos);
}

TEST_CASE("phases add up by name, in order of appearance") {
  Phases phases;
  phases.begin("read");
  phases.begin("find pairs");
  phases.begin("read");
  phases.begin("");
  REQUIRE(phases.seconds().size() == 2);
  CHECK(phases.seconds()[0].first == "read");
  CHECK(phases.seconds()[1].first == "find_pairs");
  CHECK(phases.total_seconds() >= phases.seconds()[0].second + phases.seconds()[1].second);
  CHECK(peak_memory_bytes() > 1000000);
}
