#include "evolution/loop/loop_state.h"

#include <doctest/doctest.h>

#include "transformesh/errors.h"

using namespace transformesh;

namespace {

enum class Color { red, green };

struct Loop {
  double best = 0;
  std::size_t idle = 0;
  long genus = 0;
  bool is_done = false;
  Color color = Color::red;

  void remember(LoopState& loop_state) {
    loop_state("best", best)("idle", idle)("genus", genus)("done", is_done)("color", color);
  }
};

}  // namespace

TEST_CASE("what a loop names is restored bit for bit from text") {
  for (const double best : {0.1, 5e-324, -1.7976931348623157e308}) {
    Loop loop{best, 3, -2, true, Color::green};
    LoopState kept;
    loop.remember(kept);
    Loop restored;
    LoopState loop_state(kept.text());
    restored.remember(loop_state);
    CHECK(restored.best == best);
    CHECK(restored.idle == 3);
    CHECK(restored.genus == -2);
    CHECK(restored.is_done);
    CHECK(restored.color == Color::green);
  }
}

TEST_CASE("text that is no state, and unknown names, are refused") {
  CHECK(LoopState().text().empty());
  CHECK_THROWS_AS(LoopState("best much"), InputError);
  double best = 0;
  LoopState other("idle 3");
  CHECK_THROWS_AS(other("best", best), InputError);
}
