#include <doctest/doctest.h>

#include <algorithm>

#include "entries/entries.h"
#include "transformesh/evolve_in_time.h"

using namespace transformesh;

namespace {

const Value* find(const Entries& entries, const std::string& name) {
  const auto found =
      std::ranges::find_if(entries, [&](const auto& entry) { return entry.first == name; });
  return found != entries.end() ? &found->second : nullptr;
}

}  // namespace

TEST_CASE("the number of events is reported if they were looked for") {
  TimeResult result;
  CHECK(find(entries_of(result), "events") == nullptr);
  CHECK(find(entries_of(result.evolution), "events") == nullptr);
  result.evolution.event_count = 3;
  for (const Entries& entries : {entries_of(result), entries_of(result.evolution)}) {
    REQUIRE(find(entries, "events") != nullptr);
    CHECK(std::get<std::size_t>(*find(entries, "events")) == 3);
    CHECK(std::get<std::string>(*find(entries, "stop")) == "iteration_limit");
  }
}
