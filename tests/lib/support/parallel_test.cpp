#include "support/parallel.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "transformesh/control.h"

using namespace transformesh;

namespace {

/// Each thread waits for the others, so that none takes over the work of a late thread.
std::size_t threads_used(std::size_t limit) {
  const ThreadLimit alive(static_cast<int>(limit));
  std::mutex mutex;
  std::condition_variable arrival;
  std::set<std::thread::id> ids;
  parallel_for(64, 1, [&](std::size_t, std::size_t) {
    std::unique_lock lock(mutex);
    ids.insert(std::this_thread::get_id());
    arrival.notify_all();
    arrival.wait_for(lock, std::chrono::minutes(1), [&] { return ids.size() >= limit; });
  });
  return ids.size();
}

}  // namespace

TEST_CASE("a thread limit holds while it is alive") {
  CHECK(threads_used(1) == 1);
  CHECK(threads_used(2) == 2);
  CHECK(threads_used(8) == 8);
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

TEST_CASE("of several exceptions that of the lowest range reaches the caller") {
  for (int round = 0; round < 50; ++round) {
    std::size_t thrown = 1000;
    try {
      parallel_for(1000, 1, [](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
          if (i >= 300) throw i;
      });
    } catch (const std::size_t i) {
      thrown = i;
    }
    REQUIRE(thrown == 300);
  }
}

TEST_CASE("two halves run at the same time where two threads are allowed") {
  if (std::thread::hardware_concurrency() < 2) return;
  // Each function waits up to 20 s for the other to start. If they ran one after the other, the
  // first would wait in vain.
  std::atomic<int> begun{0};
  const auto half = [&] {
    ++begun;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (begun < 2 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  };
  parallel_invoke(half, half);
  CHECK(begun == 2);
}

TEST_CASE("where one half waits for the other, a loop inside that has its thread") {
  const ThreadLimit alive(2);
  for (int round = 0; round < 20; ++round) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    std::atomic<bool> has_begun{false};
    const auto wait = [&] {
      while (!has_begun && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    };
    std::atomic<bool> have_met{false};
    const auto meet = [&] {
      has_begun = true;
      while (!have_met && std::chrono::steady_clock::now() < end) {
        std::atomic<int> inside{0};
        parallel_for(2, 1, [&](std::size_t, std::size_t) {
          ++inside;
          const auto soon = std::chrono::steady_clock::now() + std::chrono::milliseconds(20);
          while (!have_met && std::chrono::steady_clock::now() < soon) {
            if (inside == 2) have_met = true;
            std::this_thread::yield();
          }
          --inside;
        });
      }
    };
    parallel_invoke(wait, meet);
    REQUIRE(have_met);
  }
}

TEST_CASE("a loop that begins while all threads work is joined by the first that ends its work") {
  const ThreadLimit alive(2);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  const auto wait_until = [&](const std::function<bool()>& condition) {
    while (!condition() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  };
  std::atomic<int> inside{0};
  parallel_invoke([&] { wait_until([&] { return inside > 0; }); },
                  [&] {
                    parallel_for(2, 1, [&](std::size_t, std::size_t) {
                      ++inside;
                      wait_until([&] { return inside == 2; });
                    });
                  });
  CHECK(inside == 2);
  CHECK(std::chrono::steady_clock::now() < end);
}

TEST_CASE("loops inside loops end, within the limit of threads") {
  std::atomic<std::size_t> visits{0};
  std::atomic<int> at_work{0};
  std::atomic<int> most_at_work{0};
  const ThreadLimit alive(2);
  parallel_for(40, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      parallel_for(50, 1, [&](std::size_t inner_first, std::size_t inner_last) {
        const int now = ++at_work;
        for (int most = most_at_work; most < now && !most_at_work.compare_exchange_weak(most, now);)
          continue;
        std::this_thread::yield();
        visits += inner_last - inner_first;
        --at_work;
      });
    }
  });
  CHECK(visits == 2000);
  CHECK(most_at_work <= 2);
}
