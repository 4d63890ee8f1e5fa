/// Walls of single faces within bodies: only the skin around them is left, checked by counted
/// voxels and closed forms. Other sheets stay.
#include <doctest/doctest.h>

#include <array>
#include <functional>
#include <map>
#include <optional>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/clean.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

using Cell = std::array<int, 3>;
/// The number of the room of each cell that is in one. Walls separate cells of different rooms.
using Rooms = std::map<Cell, int>;
/// Returns the copies of the wall between a cell and the next cell along an axis. An entry is true
/// if the copy faces the next cell, and false if it faces the cell.
using Walls = std::function<std::vector<bool>(const Cell&, int axis)>;

class Builder {
 public:
  explicit Builder(const Rooms& rooms) : rooms_(rooms) {}
  Mesh build(const Walls& walls);

 private:
  std::optional<int> room(const Cell& cell) const {
    const auto found = rooms_.find(cell);
    return found == rooms_.end() ? std::nullopt : std::optional(found->second);
  }
  Index vertex(const Cell& corner);
  void add_square(const Cell& cell, int axis, bool looks_up);

  const Rooms& rooms_;
  std::map<Cell, Index> vertices_;
  Mesh mesh_;
};

Index Builder::vertex(const Cell& corner) {
  const auto [entry, is_new] =
      vertices_.try_emplace(corner, static_cast<Index>(mesh_.positions.size()));
  if (is_new) mesh_.positions.emplace_back(corner[0], corner[1], corner[2]);
  return entry->second;
}

/// Adds the upper side of the cell along the axis.
void Builder::add_square(const Cell& cell, int axis, bool looks_up) {
  std::array<Index, 4> corners{};
  for (int i = 0; i < 4; ++i) {
    Cell corner = cell;
    ++corner[axis];
    corner[(axis + 1) % 3] += i == 1 || i == 2 ? 1 : 0;
    corner[(axis + 2) % 3] += i >= 2 ? 1 : 0;
    corners[i] = vertex(corner);
  }
  if (!looks_up) std::swap(corners[1], corners[3]);
  mesh_.faces.push_back({corners[0], corners[1], corners[2]});
  mesh_.faces.push_back({corners[0], corners[2], corners[3]});
}

Mesh Builder::build(const Walls& walls) {
  for (int x = -1; x < 4; ++x)
    for (int y = -1; y < 4; ++y)
      for (int z = -1; z < 4; ++z)
        for (int axis = 0; axis < 3; ++axis) {
          const Cell cell{x, y, z};
          Cell next = cell;
          ++next[axis];
          if (room(cell) == room(next)) continue;
          if (!room(cell) || !room(next)) {
            add_square(cell, axis, room(cell).has_value());
          } else {
            for (const bool looks_up : walls(cell, axis)) add_square(cell, axis, looks_up);
          }
        }
  return mesh_;
}

Mesh build(const Rooms& rooms, const Walls& walls) { return Builder(rooms).build(walls); }

std::vector<bool> looking_up(const Cell&, int) { return {true}; }
std::vector<bool> looking_down(const Cell&, int) { return {false}; }

void check_body(const Mesh& mesh, double volume) {
  const CleanResult result = clean(mesh);
  const test::Count facts = test::count(result.mesh);
  CHECK(facts.is_closed_and_oriented);
  CHECK(facts.is_manifold);
  CHECK(!facts.has_isolated_vertices);
  CHECK(test::signed_volume(result.mesh) == doctest::Approx(volume).epsilon(1e-14));
  CHECK(!clean(result.mesh).changed);
}

Rooms row(int count) {
  Rooms rooms;
  for (int x = 0; x < count; ++x) rooms[{x, 0, 0}] = x;
  return rooms;
}

}  // namespace

TEST_CASE("two cubes that share a single wall become their common outer surface") {
  for (const Walls& walls : {Walls(looking_up), Walls(looking_down)}) {
    const Mesh mesh = build(row(2), walls);
    CHECK(mesh.faces.size() == 22);
    check_body(mesh, 2);
    CHECK(clean(mesh).removed_faces == 2);
    CHECK(clean(mesh).pairs == 0);
  }
}

TEST_CASE("several walls, and walls that meet in T and X shapes, are removed") {
  check_body(build(row(4), looking_up), 4);
  const Rooms tee = {{{0, 0, 0}, 0}, {{1, 0, 0}, 0}, {{0, 1, 0}, 1}, {{1, 1, 0}, 2}};
  const Rooms cross = {{{0, 0, 0}, 0}, {{1, 0, 0}, 1}, {{0, 1, 0}, 2}, {{1, 1, 0}, 3}};
  check_body(build(cross, looking_up), 4);
  check_body(build(tee, looking_up), 4);
  check_body(build(tee, looking_down), 4);
}

TEST_CASE("a room between other rooms, away from the outer surface, is filled") {
  Rooms rooms;
  for (int i = 0; i < 27; ++i) rooms[{i % 3, i / 3 % 3, i / 9}] = i;
  check_body(build(rooms, looking_up), 27);
  check_body(build(rooms, looking_down), 27);
}

TEST_CASE("a wall with a hole, and half a wall, are removed") {
  Rooms rooms;
  for (int i = 0; i < 36; ++i) rooms[{i % 4, i / 4 % 3, i / 12}] = i % 4 < 2 ? 0 : 1;
  const auto without = [&](const std::function<bool(const Cell&)>& is_gone) {
    return build(rooms, [=](const Cell& cell, int) -> std::vector<bool> {
      if (is_gone(cell)) return {};
      return {true};
    });
  };
  check_body(without([](const Cell& cell) { return cell[1] == 1 && cell[2] == 1; }), 36);
  check_body(without([](const Cell& cell) { return cell[1] == 0; }), 36);
  check_body(without([](const Cell& cell) { return cell[1] + cell[2] != 0; }), 36);
}

TEST_CASE("a wall that touches the outer surface without sharing an edge is removed") {
  Mesh wall = test::grid(3);
  for (Vec3& p : wall.positions) p = Vec3(2 * p.x(), 2 * p.y(), 0.75);
  const Mesh body = test::cuboid({0, 0, 0}, {2, 2, 2});
  check_body(test::joined(body, wall), 8);
  check_body(test::joined(body, test::reversed(wall)), 8);
}

TEST_CASE("rooms may intersect other bodies and walls") {
  const Mesh rooms = build(row(3), looking_up);
  check_body(test::joined(rooms, test::cuboid({1, -1, 0.5}, {2, 2, 3})), 3 + 7.5 - 0.5);
  check_body(test::joined(rooms, test::moved(rooms, {0.5, 0.25, 0.125})), 6 - 2.5 * 0.75 * 0.875);
}

TEST_CASE("walls given once or twice in rooms at random leave the voxels of the rooms") {
  test::Random random(11);
  int cleaned = 0;
  while (cleaned < 60) {
    Rooms rooms;
    for (int i = 0; i < 27; ++i)
      if (random.below(6) > 0) rooms[{i % 3, i / 3 % 3, i / 9}] = static_cast<int>(random.below(4));
    // Walls face rooms of smaller numbers, so no room can become a cavity among others.
    const Mesh mesh = build(rooms, [&](const Cell& cell, int axis) -> std::vector<bool> {
      Cell next = cell;
      ++next[axis];
      const bool looks_up = rooms.at(cell) > rooms.at(next);
      if (random.below(20) == 0) return {looks_up, !looks_up};
      return {looks_up};
    });
    try {
      check_body(mesh, static_cast<double>(rooms.size()));
      ++cleaned;
    } catch (const InputError&) {  // two walls traverse an edge in the same direction
    }
  }
}

TEST_CASE("sheets that are not walls inside a body stay") {
  // A cavity whose skin is in two parts, because a wall ends on it.
  Rooms shell;
  for (int i = 0; i < 27; ++i)
    if (i != 13) shell[{i % 3, i / 3 % 3, i / 9}] = i / 9 == 0 ? 0 : 1;
  check_body(build(shell, looking_up), 26);

  // A fin on the outside, and a membrane in the hole of a ring.
  Mesh fin = test::grid(1);
  for (Vec3& p : fin.positions) p = Vec3(0.5, p.x(), 1 + p.y());
  CHECK(clean(test::joined(test::cube(), fin)).removed_faces == 0);
  Rooms ring;
  for (int i = 0; i < 9; ++i)
    if (i != 4) ring[{i % 3, i / 3, 0}] = 0;
  Mesh membrane = test::grid(1);
  for (Vec3& p : membrane.positions) p += Vec3(1, 1, 0);
  const CleanResult closed = clean(test::joined(build(ring, looking_up), membrane));
  CHECK(closed.removed_faces == 0);
  CHECK(closed.mesh.faces.size() == 66);
}
