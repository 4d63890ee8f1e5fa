// Report entries of evolutions: their established names, and the words for how a run ended.
#include <doctest/doctest.h>

#include "entries/entries.h"
#include "transformesh/evolve_in_time.h"
#include "transformesh/offset.h"

using namespace transformesh;

namespace {

template <typename Held>
Held value_of(const Entries& entries, const std::string& name) {
  for (const auto& [key, value] : entries)
    if (key == name) return std::get<Held>(value);
  FAIL("no entry ", name);
  return {};
}

}  // namespace

TEST_CASE("an evolution in time reports its time, its volume and its topology") {
  TimeResult result;
  result.time = 1.5;
  result.evolution.is_done = true;
  result.evolution.iterations = 7;
  result.evolution.last.topology = {3, 2};
  result.volume = 0.25;
  result.repeated = 4;
  const Entries entries = entries_of(result);
  CHECK(value_of<std::string>(entries, "stop") == "converged");
  CHECK(value_of<std::size_t>(entries, "iterations") == 7);
  CHECK(value_of<std::size_t>(entries, "components") == 3);
  CHECK(value_of<long>(entries, "genus") == 2);
  CHECK(value_of<double>(entries, "time") == 1.5);
  CHECK(value_of<double>(entries, "volume") == 0.25);
  CHECK(value_of<std::size_t>(entries, "repeated_steps") == 4);
}

TEST_CASE("an evolution that was not done stopped at its limit") {
  CHECK(value_of<std::string>(entries_of(EvolveResult()), "stop") == "iteration_limit");
  OffsetResult offset;
  offset.has_arrived = false;
  CHECK(value_of<std::string>(entries_of(offset), "stop") == "iteration_limit");
  offset.has_arrived = offset.has_missed = true;
  CHECK(value_of<std::string>(entries_of(offset), "stop") == "missed");
  offset.has_missed = false;
  CHECK(value_of<std::string>(entries_of(offset), "stop") == "converged");
}
