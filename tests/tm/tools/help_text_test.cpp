#include "help_text.h"

#include <doctest/doctest.h>

#include "command.h"

using namespace transformesh;
using namespace transformesh::tool;

TEST_CASE("help is made from the table") {
  Length edge{0.01, Length::Unit::diagonal};
  bool keep = false;
  std::string kind = "sphere";
  Command command{"tm-x", "[OPTION]... KIND", "Does it"};
  command.words_placeholder = "KIND";
  command.words_help = "which";
  command.epilogs = {"Once more."};
  OptionTable& table = command.table;
  table.add(length_option("edge", &edge, "mean edge length", false));
  table.add(flag_option("keep-border", &keep,
                        "leave every border as it is, which means that no vertex of it moves and "
                        "that no edge of it is split"));
  Option common = choice_option("kind-of-a-long-name", &kind, {"sphere", "box"}, "a choice");
  common.is_common = true;
  common.short_name = 'k';
  table.add(common);
  CHECK(help_text(command) == R"(Usage: tm-x [OPTION]... KIND

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
