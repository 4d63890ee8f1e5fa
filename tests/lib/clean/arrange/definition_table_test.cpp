#include "clean/arrange/definition_table.h"

#include <doctest/doctest.h>

using namespace transformesh;

TEST_CASE("definitions are found again, however many there are, and others are not") {
  for (const Index count : {Index{0}, Index{1}, Index{23}, Index{24}, Index{25}, Index{5000}}) {
    CAPTURE(count);
    DefinitionTable table;
    for (Index i = 0; i < count; ++i) table.insert(PointDefinition::line_plane(i, i / 3, 7), i);
    for (Index i = 0; i < count; ++i) {
      REQUIRE(table.find(PointDefinition::line_plane(i / 3, i, 7)) == i);
      REQUIRE(table.find(PointDefinition::line_plane(i, i / 3, 8)) == no_index);
      REQUIRE(table.find(PointDefinition::three_planes(i, i / 3, 7)) == no_index);
    }
    CHECK(table.find(PointDefinition::given(count)) == no_index);
  }
}

TEST_CASE("the order of edges and faces does not matter to a definition") {
  CHECK(PointDefinition::line_line(1, 2, 3, 4) == PointDefinition::line_line(4, 3, 2, 1));
  CHECK(PointDefinition::line_line(1, 2, 3, 4) != PointDefinition::line_line(1, 3, 2, 4));
  CHECK(PointDefinition::line_line(1, 2, 1, 4) == PointDefinition::line_line(4, 1, 1, 2));
  CHECK(PointDefinition::three_planes(3, 1, 2) == PointDefinition::three_planes(2, 3, 1));
  CHECK(PointDefinition::line_plane(5, 2, 9) == PointDefinition::line_plane(2, 5, 9));
  CHECK(!PointDefinition().is_known());
}
