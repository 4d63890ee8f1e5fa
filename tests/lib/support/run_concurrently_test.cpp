#include "support/run_concurrently.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "support/parallel.h"
#include "transformesh/control.h"

using namespace transformesh;

TEST_CASE("concurrent work uses a free thread, or runs second if there is none") {
  const auto own_thread = std::this_thread::get_id();
  for (const int limit : {1, 2}) {
    const ThreadLimit alive(limit);
    std::thread::id own, other;
    std::atomic<bool> own_has_ended{false};
    bool other_was_late = false;
    run_concurrently(
        [&] {
          own = std::this_thread::get_id();
          std::this_thread::sleep_for(std::chrono::milliseconds(5));
          own_has_ended = true;
        },
        [&] {
          other = std::this_thread::get_id();
          other_was_late = own_has_ended;
        });
    CHECK(own == own_thread);
    CHECK((other == own_thread) == (limit == 1));
    if (limit == 1) CHECK(other_was_late);
  }
}

TEST_CASE("an exception of this thread is rethrown after the other has ended") {
  const ThreadLimit alive(2);
  std::atomic<bool> other_has_ended{false};
  const auto fail = [] { throw std::runtime_error("own"); };
  CHECK_THROWS_AS(run_concurrently(fail,
                                   [&] {
                                     std::this_thread::sleep_for(std::chrono::milliseconds(5));
                                     other_has_ended = true;
                                   }),
                  std::runtime_error);
  CHECK(other_has_ended);
}

TEST_CASE("loops of one take the thread of the other when that has ended, and all are given back") {
  const ThreadLimit alive(2);
  for (int round = 0; round < 20; ++round) {
    std::atomic<int> sum{0};
    const auto add = [&] {
      parallel_for(100, 1, [&](std::size_t first, std::size_t last) {
        sum += static_cast<int>(last - first);
      });
    };
    run_concurrently(add, add);
    CHECK(sum == 200);
  }
  std::thread::id other;
  run_concurrently([] {}, [&] { other = std::this_thread::get_id(); });
  CHECK(other != std::this_thread::get_id());
}
