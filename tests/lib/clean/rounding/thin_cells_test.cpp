/// Thin cells become inside or outside, whichever leaves less surface: gaps close, thin sheets
/// vanish, and thicker parts stay as they are.
#include "clean/rounding/thin_cells.h"

#include <doctest/doctest.h>

#include <memory>

#include "clean/exterior/exterior_arrangement.h"
#include "clean/intersect/find_meetings.h"
#include "helpers/shapes.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

using test::cuboid;
using test::joined;

/// The arrangement of a mesh and its kept pieces, before or after thin cells have become inside or
/// outside.
struct Cells {
  explicit Cells(const Mesh& mesh) {
    const auto welded = std::make_shared<const WeldedMesh>(weld(mesh));
    ExteriorArrangement exterior = arrange_exterior(welded, find_meetings(*welded, Progress()),
                                                    {1, true, nullptr}, Progress());
    arrangement = std::move(exterior.arrangement);
    kept = std::move(exterior.kept);
  }
  double volume() const {
    double sum = 0;
    for (std::size_t p = 0; p < kept.size(); ++p) {
      if (!kept[p]) continue;
      const auto& [a, b, c] = arrangement.pieces[p].corners;
      sum += arrangement.position(a).dot(arrangement.position(b).cross(arrangement.position(c)));
    }
    return sum / 6;
  }
  std::optional<Displacement> give(double spacings, std::vector<std::uint8_t> levels = {}) {
    levels.resize(arrangement.welded->faces.size(), 0);
    Displacement moved;
    const bool is_any =
        give_thin_cells_away(arrangement, kept, {2 * spacings, levels, Scalar::float32}, moved);
    return is_any ? std::optional(moved) : std::nullopt;
  }

  Arrangement arrangement;
  std::vector<char> kept;
};

constexpr double spacing = 0x1p-23;  // spacing of floats from 1 to 2

/// A box with a closed slit of this width inside.
Mesh slit_box(double width) {
  return joined(cuboid({1, 1, 1}, {1.9, 1.9, 1.9}),
                test::reversed(cuboid({1.2, 1.2, 1.4}, {1.7, 1.7, 1.4 + width})));
}

}  // namespace

TEST_CASE("a gap between bodies that touch all around it is closed") {
  // Two touching boxes; one of them has a hollow of a few spacings in the common face.
  const double width = 4 * spacing;
  const Mesh boxes =
      joined(cuboid({1, 1, 1}, {1.9, 1.9, 1.4}), cuboid({1, 1, 1.4}, {1.9, 1.9, 1.9}));
  const Mesh hollow = test::reversed(cuboid({1.2, 1.2, 1.4}, {1.7, 1.7, 1.4 + width}));
  Cells cells(joined(boxes, hollow));
  CHECK(cells.volume() == doctest::Approx(0.9 * 0.9 * 0.9 - 0.25 * width).epsilon(1e-12));
  CHECK(!cells.give(2));
  const std::optional<Displacement> given = cells.give(16);
  REQUIRE(given.has_value());
  CHECK(given->length == doctest::Approx(width));
  CHECK(cells.volume() == doctest::Approx(0.9 * 0.9 * 0.9).epsilon(1e-14));
}

TEST_CASE("a slit inside a box closes, a wide one stays") {
  Cells thin(slit_box(4 * spacing));
  CHECK(thin.give(16).has_value());
  CHECK(thin.volume() == doctest::Approx(0.9 * 0.9 * 0.9).epsilon(1e-14));
  Cells wide(slit_box(0.1));
  CHECK(!wide.give(16).has_value());
  CHECK(wide.volume() == doctest::Approx(0.9 * 0.9 * 0.9 - 0.025));
}

TEST_CASE("a thin sheet beside a body vanishes, and the body stays") {
  Cells cells(
      joined(cuboid({1, 1, 1}, {1.5, 1.5, 1.5}), cuboid({1.6, 1, 1}, {1.9, 1.5, 1 + 3 * spacing})));
  REQUIRE(cells.give(16).has_value());
  CHECK(cells.volume() == doctest::Approx(0.125).epsilon(1e-14));
}

TEST_CASE("of two thin sheets only the one with a coarser grid vanishes") {
  const double thickness = 3 * spacing;
  const Mesh thin_sheet = cuboid({1.6, 1, 1}, {1.9, 1.5, 1 + thickness});
  const Mesh other = cuboid({1, 1.6, 1}, {1.5, 1.8, 1 + thickness});
  const Mesh both = joined(thin_sheet, other);
  Cells cells(both);
  std::vector<std::uint8_t> levels(both.faces.size(), 0);
  CHECK(!cells.give(1, levels).has_value());
  levels[thin_sheet.faces.size() + 5] = 2;
  CHECK(cells.give(1, levels).has_value());
  CHECK(cells.volume() == doctest::Approx(0.3 * 0.5 * thickness).epsilon(1e-6));
  CHECK(cells.give(16).has_value());
  CHECK(cells.volume() == 0);
}

TEST_CASE(
    "thickness counts in spacings of the place: the same thin sheet is thick near the origin") {
  const Mesh thin_sheet =
      cuboid({0x1p-30, 0x1p-30, 0x1p-30}, {0x1p-29, 0x1p-29, 0x1p-30 + spacing / 512});
  Cells cells(joined(cuboid({1, 1, 1}, {1.5, 1.5, 1.5}), thin_sheet));
  CHECK(!cells.give(16).has_value());
}
