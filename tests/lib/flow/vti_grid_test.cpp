#include <doctest/doctest.h>

#include <cstring>
#include <string>

#include "helpers/random.h"
#include "support/base64.h"
#include "transformesh/flow.h"

using namespace transformesh;

namespace {

struct Parts {
  std::string image = "WholeExtent=\"0 1 0 2 0 0\" Origin=\"1 2 3\" Spacing=\".5 .25 1\"";
  std::string piece = "Extent=\"0 1 0 2 0 0\"";
  std::string points = "Vectors=\"v\"";
  std::string array = "format=\"ascii\">0 0 1  1 0 1  2 0 1  3 0 1  4 0 1  5 0 1";
  std::string cells, field, end;
};

std::string vti(const Parts& p) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt32\"><ImageData " +
         p.image + ">" + p.field + "<Piece " + p.piece + "><PointData " + p.points +
         "><DataArray Name=\"p\" type=\"Float64\" format=\"ascii\">9 9 9 9 9 9</DataArray>" +
         (p.array.empty() ? ""
                          : "<DataArray Name=\"v\" type=\"Float64\" NumberOfComponents=\"3\" " +
                                p.array + "</DataArray>") +
         "</PointData><CellData>" + p.cells + "</CellData></Piece></ImageData>" + p.end +
         "</VTKFile>";
}

FlowGrid read(const Parts& parts, std::size_t components = 3) {
  return read_flow_grid(vti(parts), "a.vti", components);
}

/// Returns whether reading is refused with a message that contains these words.
bool refuses(const Parts& parts, const std::string& words, std::size_t components = 3) {
  try {
    read(parts, components);
  } catch (const InputError& error) {
    INFO(error.what());
    CHECK(std::string(error.what()).find(words) != std::string::npos);
    return std::string(error.what()).find(words) != std::string::npos;
  }
  return false;
}

/// Six vectors as VTK stores them: their size in bytes, and little-endian doubles.
std::string block() {
  std::string bytes;
  const auto append = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  append(std::uint32_t{18 * 8});
  for (int i = 0; i < 6; ++i)
    for (const double value : {static_cast<double>(i), 0.0, 1.0}) append(value);
  return bytes;
}

void check_is_usual(const FlowGrid& grid) {
  CHECK(grid.size == std::array<std::size_t, 3>{2, 3, 1});
  CHECK(grid.origin == Vec3(1, 2, 3));
  CHECK(grid.spacing == Vec3(.5, .25, 1));
  REQUIRE(grid.values.size() == 18);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(grid.values[3 * i] == static_cast<double>(i));
    CHECK(grid.values[3 * i + 2] == 1);
  }
}

}  // namespace

TEST_CASE("ImageData is the same grid as text, in base64, and appended raw or in base64") {
  Parts parts;
  check_is_usual(read(parts));
  parts.array = "format=\"binary\">" + base64(block());
  check_is_usual(read(parts));
  parts.array = "format=\"appended\" offset=\"0\">";
  parts.end = "<AppendedData encoding=\"raw\">\n_" + block() + "\n</AppendedData>";
  check_is_usual(read(parts));
  parts.end = "<AppendedData encoding=\"base64\">\n_" + base64(block()) + "\n</AppendedData>";
  check_is_usual(read(parts));
}

TEST_CASE("extents move the origin, and the field TimeValue is the time") {
  Parts parts;
  CHECK(!read(parts).time);
  parts.image = "WholeExtent=\"4 5 0 2 0 0\" Origin=\"1 2 3\" Spacing=\".5 .25 1\"";
  parts.piece = "Extent=\"4 5 0 2 0 0\"";
  parts.field =
      "<FieldData><DataArray Name=\"TimeValue\" type=\"Float64\" NumberOfTuples=\"1\" "
      "format=\"ascii\">0.75</DataArray></FieldData>";
  const FlowGrid grid = read(parts);
  CHECK(grid.origin == Vec3(3, 2, 3));
  CHECK(grid.time == 0.75);
}

TEST_CASE("scalars, a single array and values of cells are found") {
  Parts parts;
  CHECK(read(parts, 1).values == std::vector<double>(6, 9));
  parts.points = "";
  check_is_usual(read(parts));
  parts.array = "";
  parts.cells =
      "<DataArray Name=\"c\" type=\"Float32\" NumberOfComponents=\"3\" "
      "format=\"ascii\">1 2 3 4 5 6</DataArray>";
  const FlowGrid grid = read(parts);
  CHECK(grid.size == std::array<std::size_t, 3>{1, 2, 1});
  CHECK(grid.origin == Vec3(1.25, 2.125, 3));
  CHECK(grid.values == std::vector<double>{1, 2, 3, 4, 5, 6});
}

TEST_CASE("ImageData that is no suitable grid is refused with the reason") {
  Parts parts;
  parts.array = "";
  CHECK(refuses(parts, "has no array of vectors"));
  parts = {};
  parts.array = "format=\"ascii\">0 0 1";
  CHECK(refuses(parts, "has 6 nodes, and its array 3 numbers"));
  parts.array = "format=\"ascii\">0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 nan";
  CHECK(refuses(parts, "a value of node 5"));
  parts = {};
  parts.image += " Direction=\"0 1 0 -1 0 0 0 0 1\"";
  CHECK(refuses(parts, "axes other than x, y and z"));
  parts = {};
  parts.piece = "Extent=\"0 1 0 2 0 99999999999\"";
  CHECK(refuses(parts, "each axis of the grid must have"));
  parts = {};
  parts.image = "WholeExtent=\"0 1 0 2 0 0\" Spacing=\"0 1 1\"";
  CHECK(refuses(parts, "spacing"));
  parts = {};
  parts.points = "";
  parts.array +=
      "</DataArray><DataArray Name=\"w\" type=\"Float64\" NumberOfComponents=\"3\" "
      "format=\"ascii\">";
  CHECK(refuses(parts, "several arrays of vectors"));
  std::string other = vti({});
  other.replace(other.find("type=\"ImageData\""), 16, "type=\"PolyData\"");
  CHECK_THROWS_AS(read_flow_grid(other, "a.vti", 3), InputError);
  CHECK_THROWS_AS(read_flow_grid("", "a.vti", 3), InputError);
  CHECK_THROWS_AS(read_flow_grid("ply\n", "a.vti", 3), InputError);
}

TEST_CASE("damaged ImageData is read or refused, and causes no other failure") {
  Parts parts;
  parts.array = "format=\"appended\" offset=\"0\">";
  parts.end = "<AppendedData encoding=\"raw\">\n_" + block() + "\n</AppendedData>";
  const std::string whole = vti(parts);
  test::Random random(5);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes = whole;
    for (int change = 0; change < 3; ++change)
      bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
    if (i % 2 == 0) bytes.resize(random.below(bytes.size()));
    try {
      const FlowGrid grid = read_flow_grid(bytes, "a.vti", 3);
      CHECK(grid.values.size() == 3 * grid.size[0] * grid.size[1] * grid.size[2]);
    } catch (const InputError&) {
    }
  }
}
