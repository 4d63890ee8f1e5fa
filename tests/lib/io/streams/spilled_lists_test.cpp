#include "io/streams/spilled_lists.h"

#include <doctest/doctest.h>

#include "helpers/random.h"
#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"

using namespace transformesh;

TEST_CASE("lists are read back unchanged, long or empty, and leave no file") {
  const test::TemporaryFolder folder;
  std::vector<std::vector<std::uint32_t>> expected(4);
  {
    SpilledLists lists(folder / "", 4);
    CHECK(folder.is_empty());
    test::Random random(3);
    for (int i = 0; i < 100000; ++i) {
      const std::size_t list = random.below(4) % 3;
      const auto index = static_cast<std::uint32_t>(random.bits());
      lists.add(list, index);
      expected[list].push_back(index);
    }
    for (std::size_t i = 0; i < 4; ++i) CHECK(lists.read(i) == expected[i]);
  }
  CHECK(expected[0].size() > 20000);
  CHECK(folder.is_empty());
}

TEST_CASE("a folder that is missing is refused") {
  CHECK_THROWS_AS(SpilledLists("/no/such/folder", 1), OutputError);
}
