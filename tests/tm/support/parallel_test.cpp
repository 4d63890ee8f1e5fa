#include "tm/support/parallel.h"

#include <doctest/doctest.h>

#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace transformesh;

namespace {

std::size_t threads_used(int limit) {
  const ThreadLimit alive(limit);
  std::mutex mutex;
  std::set<std::thread::id> ids;
  parallel_for(64, 1, [&](std::size_t, std::size_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::lock_guard lock(mutex);
    ids.insert(std::this_thread::get_id());
  });
  return ids.size();
}

}  // namespace

TEST_CASE("a thread limit holds while it is alive") {
  CHECK(threads_used(1) == 1);
  CHECK(threads_used(2) <= 2);
  CHECK(threads_used(1) == 1);
}

TEST_CASE("ranges cover every index once") {
  for (const std::size_t count : {0, 1, 7, 1000}) {
    std::vector<int> visits(count, 0);
    parallel_for(count, 10, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) ++visits[i];
    });
    CHECK(visits == std::vector<int>(count, 1));
  }
}

TEST_CASE("an exception in a body reaches the caller") {
  const auto fail = [](std::size_t, std::size_t last) {
    if (last == 100) throw std::runtime_error("the last range");
  };
  CHECK_THROWS_AS(parallel_for(100, 1, fail), std::runtime_error);
}
