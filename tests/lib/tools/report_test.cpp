#include "frame/report.h"

#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

using namespace transformesh::tool;

TEST_CASE("values as text") {
  CHECK(text_of(0.1) == "0.1");
  CHECK(text_of(1.0) == "1");
  CHECK(text_of(std::nan("")) == "nan");
  CHECK(text_of(14) == "14");
  CHECK(text_of(true) == "true");
  CHECK(text_of("no \"ne") == "no \"ne");
  CHECK(text_of(std::vector<double>{0, -1.5, 1e-20}) == "0 -1.5 1e-20");
  CHECK(text_of(std::vector<double>{1, 2}, ",") == "1,2");
}

TEST_CASE("JSON stays valid for numbers that it lacks and bytes that are no text") {
  const std::string text = json_text({{"mean", std::nan("")}, {"name", "a\xff\"b"}});
  CHECK(Json::accept(text));
  CHECK(text.find("\"mean\": null") != std::string::npos);
}

TEST_CASE("phases add up by name, in order of appearance") {
  Phases phases;
  phases.begin("read");
  phases.begin("find pairs");
  phases.begin("read");
  phases.begin("");
  const Json seconds = phases.seconds();
  CHECK(seconds.size() == 3);
  CHECK(seconds.begin().key() == "read");
  CHECK(seconds.contains("find_pairs"));
  CHECK(seconds["total"] >= seconds["read"].get<double>() + seconds["find_pairs"].get<double>());
  CHECK(peak_memory_bytes() > 1000000);
}
