#include <doctest/doctest.h>

#include "frame/program.h"

using namespace transformesh;
using namespace transformesh::tool;

TEST_CASE("help is made from the options") {
  Length edge{0.01, Length::Unit::diagonal};
  bool keep = false;
  std::string kind = "sphere";
  Program program{"tm-x", "[OPTION]... KIND", "Does it"};
  program.words = {"KIND", "which"};
  program.epilog = "Once more.";
  program.options.length("edge", &edge, "mean edge length");
  program.options.flag(
      "keep-border", &keep,
      "leave every border as it is, which means that no vertex of it moves and that no "
      "edge of it is split");
  program.options.choice("kind-of-a-long-name,k", &kind, {"sphere", "box"}, "a choice");
  program.options.find("kind-of-a-long-name")->is_common = true;
  CHECK(help_text(program) == R"(Usage: tm-x [OPTION]... KIND

Does it.

Arguments:
  KIND                    which

Options:
  --edge LENGTH           mean edge length (default 1%)
  --keep-border           leave every border as it is, which means that no
                          vertex of it moves and that no edge of it is split

Common options:
  -k, --kind-of-a-long-name sphere|box
                          a choice (default sphere)

A LENGTH is 0.02 (input units), 1% (of the bounding box's diagonal) or 0.7x (of
the reference edge).

Once more.

Exit codes: 0 done, 2 usage, 3 bad input, 4 goal not reached, 5 output failed,
            6 out of memory.
)");
}
