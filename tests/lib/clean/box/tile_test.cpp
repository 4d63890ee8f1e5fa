#include "clean/box/tile.h"

#include <doctest/doctest.h>

#include <limits>

#include "transformesh/errors.h"

using namespace transformesh;

namespace {

Tile example() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{0xfedcba9876543210U, 3, 16},
          42,
          {Vec3(-infinity, .1, 1e-300), Vec3(0, infinity, 1. / 3)},
          {Vec3(-1, -2, -3), Vec3(1, 2, 3)},
          {Vec3(.5, -.25, 1e22), -2},
          1e-3,
          Scalar::float32};
}

}  // namespace

TEST_CASE("a comment holds a tile without loss") {
  const Tile tile = example();
  const auto read = tile_of({"made by hand", tile_comment(tile)});
  REQUIRE(read);
  CHECK(read->name == tile.name);
  CHECK(read->faces == tile.faces);
  CHECK(read->own.min() == tile.own.min());
  CHECK(read->own.max() == tile.own.max());
  CHECK(read->held.min() == tile.held.min());
  CHECK(read->held.max() == tile.held.max());
  CHECK(read->reference.position == tile.reference.position);
  CHECK(read->reference.winding == tile.reference.winding);
  CHECK(read->cell_size == tile.cell_size);
  CHECK(read->coordinate == tile.coordinate);
  CHECK(cleaned_tile_of({cleaned_tile_comment(tile.name)}) == tile.name);
}

TEST_CASE("meshes without the comment are no tiles, and each kind is told apart") {
  const Tile tile = example();
  CHECK(!tile_of({}));
  CHECK(!tile_of({"tm:tiles", cleaned_tile_comment(tile.name)}));
  CHECK(!cleaned_tile_of({tile_comment(tile)}));
  std::vector<std::string> comments{"a", tile_comment(tile), "b", cleaned_tile_comment(tile.name)};
  drop_tile_comments(comments);
  CHECK(comments == std::vector<std::string>{"a", "b"});
}

TEST_CASE("a comment that is cut off, too long or no number is refused") {
  const std::string text = tile_comment(example());
  CHECK_THROWS_AS(tile_of({text.substr(0, text.rfind(' '))}), InputError);
  CHECK_THROWS_AS(tile_of({text + " 1"}), InputError);
  CHECK_THROWS_AS(tile_of({"tm:tile one 16 1"}), InputError);
  CHECK_THROWS_AS(tile_of({"tm:tile 16 16 1"}), InputError);
  CHECK_THROWS_AS(cleaned_tile_of({"tm:cleaned-tile 16 16 1"}), InputError);
  CHECK_THROWS_AS(cleaned_tile_of({"tm:cleaned-tile 1 16"}), InputError);
}
