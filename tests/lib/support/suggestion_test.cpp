#include "support/suggestion.h"

#include <doctest/doctest.h>

using transformesh::is_near;
using transformesh::nearest_name;

TEST_CASE("the nearest name by edits") {
  const std::vector<std::string> names = {"output", "min-edge", "max-edge", "format", "float"};
  CHECK(nearest_name("outptu", names) == "output");
  CHECK(nearest_name("mix-edge", names) == "min-edge");
  CHECK(nearest_name("flaot", names) == "float");
  CHECK(nearest_name("", names) == "float");
}

TEST_CASE("a prefix is one edit, and the first of equals wins") {
  CHECK(nearest_name("iter", {"filter", "iterations"}) == "iterations");
  CHECK(nearest_name("m", {"max", "min"}) == "max");
  CHECK(nearest_name("anything", {}) == "");
}

TEST_CASE("a name is near if fewer than half of the letters differ, or if the text begins it") {
  CHECK(is_near("versoin", "version"));
  CHECK(is_near("hel", "help"));
  CHECK(is_near("boks", "box") == false);
  CHECK(is_near("weld", "help") == false);
  CHECK(is_near("cone", "bone"));
  CHECK(is_near("cone", "box") == false);
}
