#include "transformesh/columns.h"

#include <doctest/doctest.h>

using namespace transformesh;

namespace {

/// A float column, a color, a label and a list of four rows.
Columns four_rows() {
  Columns columns;
  columns.get("height", Scalar::float64, 4).values = {0, 1, 2, 4};
  columns.get("red", Scalar::uint8, 4).values = {0, 10, 21, 255};
  columns.get("label", Scalar::int16, 4).values = {-1, 5, 6, 7};
  Column& list = columns.get("tags", Scalar::int8, 0);
  list.list_count_type = Scalar::uint8;
  list.values = {1, 2, 3};
  list.list_offsets = {0, 0, 1, 3, 3};
  return columns;
}

const Column& column(const Columns& columns, const char* name) { return *columns.find(name); }

using Values = std::vector<double>;
using Offsets = std::vector<std::size_t>;

}  // namespace

TEST_CASE("a column for results replaces one of its name, of any type") {
  for (const char* name : {"height", "red", "tags"}) {
    Columns columns = four_rows();
    Column& made = columns.get(name, Scalar::int32, 3);
    CHECK(&made == columns.find(name));
    CHECK(made.type == Scalar::int32);
    CHECK(made.values == Values{0, 0, 0});
    CHECK(!made.list_count_type);
    CHECK(made.list_offsets.empty());
    CHECK(columns.columns.size() == 4);
    CHECK(columns.columns[1].name == "red");
  }
  Columns columns = four_rows();
  columns.get("more", Scalar::uint16, 4);
  CHECK(columns.columns.back().name == "more");
  CHECK(columns.columns.size() == 5);
}

TEST_CASE("erasing leaves the other columns in their order") {
  Columns columns = four_rows();
  columns.erase("red");
  columns.erase("absent");
  CHECK(columns.columns.size() == 3);
  CHECK(columns.columns[1].name == "label");
  CHECK(columns.find("red") == nullptr);
}

TEST_CASE("rows are selected in any order, repeated ones too") {
  const Columns selected = four_rows().select(std::vector<std::uint32_t>{2, 0, 2});
  CHECK(column(selected, "height").values == Values{2, 0, 2});
  CHECK(column(selected, "label").values == Values{6, -1, 6});
  CHECK(column(selected, "tags").values == Values{2, 3, 2, 3});
  CHECK(column(selected, "tags").list_offsets == Offsets{0, 2, 2, 4});
}

TEST_CASE("blending interpolates floats and colors; labels and lists follow the largest weight") {
  const std::vector<RowBlend> rows = {{{0, 1, 3}, {0.25, 0.25, 0.5}}, {{1, 2, 0}, {0.5, 0.5, 0}}};
  Columns blended = four_rows().blend(rows);
  CHECK(column(blended, "height").values == Values{2.25, 1.5});
  CHECK(column(blended, "red").values == Values{130, 16});  // rounded from 130 and 15.5
  CHECK(column(blended, "label").values == Values{7, 5});
  CHECK(column(blended, "tags").list_offsets == Offsets{0, 0, 1});
  CHECK(column(blended, "tags").values == Values{1});

  // Appends a blend of rows of the table itself, in place.
  blended.append({{1, 0, 0}, {0.75, 0.25, 0}});
  CHECK(column(blended, "height").values == Values{2.25, 1.5, 1.6875});
  CHECK(column(blended, "tags").list_offsets == Offsets{0, 0, 1, 2});
  CHECK(column(blended, "tags").values == Values{1, 1});
}

TEST_CASE("concatenation unites columns by name; what one lacks is zero or empty there") {
  Columns first = four_rows();
  Columns second;
  second.get("label", Scalar::int32, 2).values = {70000, 8};
  second.get("tags", Scalar::int8, 2).values = {9, 9};  // this column is not a list
  second.get("mass", Scalar::float32, 2).values = {0.5, 0.25};
  CHECK(first.concatenate(second, 4, 2) == std::vector<std::string>{"tags"});
  CHECK(column(first, "height").values == Values{0, 1, 2, 4, 0, 0});
  CHECK(column(first, "tags").list_offsets == Offsets{0, 0, 1, 3, 3, 3, 3});
  CHECK(column(first, "mass").values == Values{0, 0, 0, 0, 0.5, 0.25});
  CHECK(column(first, "label").values == Values{-1, 5, 6, 7, 70000, 8});
}

TEST_CASE("concatenated types hold the values of both") {
  const auto united = [](Scalar first, Scalar second) {
    Columns columns;
    columns.get("value", first, 1);
    Columns other;
    other.get("value", second, 1);
    columns.concatenate(other, 1, 1);
    return columns.columns[0].type;
  };
  CHECK(united(Scalar::int16, Scalar::int32) == Scalar::int32);
  CHECK(united(Scalar::uint8, Scalar::int8) == Scalar::int16);
  CHECK(united(Scalar::uint16, Scalar::int8) == Scalar::int32);
  CHECK(united(Scalar::uint32, Scalar::int8) == Scalar::float64);
  CHECK(united(Scalar::uint8, Scalar::float32) == Scalar::float32);
  CHECK(united(Scalar::int32, Scalar::float32) == Scalar::float64);
  CHECK(united(Scalar::float64, Scalar::float32) == Scalar::float64);
}

TEST_CASE("concatenated colors of different types have one scale") {
  const auto joined = [](const char* name, Scalar first, double value, Scalar second,
                         double other_value) {
    Columns columns;
    columns.get(name, first, 1).values = {value};
    Columns other;
    other.get(name, second, 1).values = {other_value};
    columns.concatenate(other, 1, 1);
    return columns.columns[0];
  };
  const Column red = joined("red", Scalar::float64, 0.5, Scalar::uint8, 51);
  CHECK(red.type == Scalar::float64);
  CHECK(red.values == Values{0.5, 51 / 255.0});
  CHECK(joined("alpha", Scalar::uint16, 65535, Scalar::float64, 0.5).values == Values{1, 0.5});
  const Column single = joined("blue", Scalar::uint8, 128, Scalar::float32, 0.25);
  CHECK(single.type == Scalar::float32);
  CHECK(single.values == Values{static_cast<double>(128 / 255.0F), 0.25});
  const Column wide = joined("green", Scalar::uint8, 128, Scalar::uint16, 9);
  CHECK(wide.type == Scalar::uint16);
  CHECK(wide.values == Values{128 * 257, 9});
  const Column mixed = joined("green", Scalar::int32, 255, Scalar::uint16, 65535);
  CHECK(mixed.type == Scalar::float64);
  CHECK(mixed.values == Values{1, 1});
  CHECK(joined("red", Scalar::uint8, 255, Scalar::int32, 7).values == Values{255, 7});
  CHECK(joined("height", Scalar::uint8, 255, Scalar::float64, 0.5).values == Values{255, 0.5});
}

TEST_CASE("colors that are filled in are white in the scale of the final type") {
  Columns columns;
  Columns bytes;
  bytes.get("red", Scalar::uint8, 1).values = {0};
  columns.concatenate(bytes, 1, 1);
  CHECK(columns.columns[0].values == Values{255, 0});
  Columns decimals;
  decimals.get("red", Scalar::float64, 1).values = {0.5};
  columns.concatenate(decimals, 2, 1);
  columns.concatenate({}, 3, 1);
  CHECK(columns.columns[0].values == Values{1, 0, 0.5, 1});

  Columns wide;
  wide.get("alpha", Scalar::uint16, 1).values = {3};
  wide.concatenate({}, 1, 1);
  CHECK(wide.columns[0].values == Values{3, 65535});
}
