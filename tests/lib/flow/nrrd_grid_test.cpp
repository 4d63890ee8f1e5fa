#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "helpers/random.h"
#include "transformesh/flow.h"

using namespace transformesh;

namespace {

const std::string usual =
    "NRRD0004\n# made by hand\ntype: double\ndimension: 4\nsizes: 3 2 1 2\nencoding: raw\n"
    "endian: little\n";

/// Bytes of `count` numbers 0, 1, 2 and so on, little-endian or big-endian.
template <class T>
std::string data(int count, bool is_big = false) {
  std::string bytes;
  for (int i = 0; i < count; ++i) {
    const T value = static_cast<T>(i);
    std::string one(reinterpret_cast<const char*>(&value), sizeof(value));
    if (is_big) std::ranges::reverse(one);
    bytes += one;
  }
  return bytes;
}

FlowGrid read(const std::string& bytes, std::size_t components = 3) {
  return read_flow_grid(bytes, "a.nrrd", components);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

bool refuses(const std::string& bytes, const std::string& words, std::size_t components = 3) {
  try {
    read(bytes, components);
  } catch (const InputError& error) {
    INFO(error.what());
    CHECK(std::string(error.what()).find(words) != std::string::npos);
    return true;
  }
  return false;
}

}  // namespace

TEST_CASE("NRRD has its vectors in the order of the file, with spacing, origin and time") {
  const FlowGrid plain = read(usual + "\n" + data<double>(12));
  CHECK(plain.size == std::array<std::size_t, 3>{2, 1, 2});
  CHECK(plain.origin == Vec3::Zero());
  CHECK(plain.spacing == Vec3::Ones());
  CHECK(!plain.time);
  REQUIRE(plain.values.size() == 12);
  CHECK(plain.values[11] == 11);

  const FlowGrid placed = read(
      usual + "spacings: NaN 0.5 2 .25\naxis mins: nan 1 2 3\ntime:=0.5\n\n" + data<double>(12));
  CHECK(placed.spacing == Vec3(0.5, 2, 0.25));
  CHECK(placed.origin == Vec3(1, 2, 3));
  CHECK(placed.time == 0.5);

  const FlowGrid medical =
      read(usual +
           "space dimension: 3\nspace directions: none (2,0,0) (0, 3, 0) (0,0,4)\n"
           "space origin: (-1,-2,-3)\r\n\r\n" +
           data<double>(12));
  CHECK(medical.spacing == Vec3(2, 3, 4));
  CHECK(medical.origin == Vec3(-1, -2, -3));
}

TEST_CASE("floats, big-endian numbers and scalars are read") {
  const std::string big = replaced(usual, "little", "big");
  CHECK(read(big + "\n" + data<double>(12, true)).values ==
        read(usual + "\n" + data<double>(12)).values);
  const std::string floats = replaced(usual, "double", "float");
  CHECK(read(floats + "\n" + data<float>(12)).values[5] == 5);
  const std::string scalars =
      replaced(replaced(usual, "dimension: 4", "dimension: 3"), "3 2 1 2", "2 1 2");
  CHECK(read(scalars + "\n" + data<double>(4), 1).values == std::vector<double>{0, 1, 2, 3});
}

TEST_CASE("NRRD that is no suitable grid is refused with the reason") {
  std::string bytes("\n");
  bytes += data<double>(12);
  CHECK(refuses(replaced(usual, "raw", "gzip") + bytes, "encoding"));
  CHECK(refuses(replaced(usual, "double", "short") + bytes, "type"));
  CHECK(refuses(replaced(usual, "little", "middle") + bytes, "endian"));
  CHECK(refuses(usual + "data file: a.raw\n" + bytes, "separate file"));
  CHECK(refuses(usual + bytes, "dimension", 1));
  CHECK(refuses(replaced(usual, "3 2 1 2", "2 3 1 2") + bytes, "first NRRD axis has 2"));
  CHECK(refuses(replaced(usual, "3 2 1 2", "3 2 1 3") + bytes, "announces 18 numbers"));
  CHECK(refuses(replaced(usual, "3 2 1 2", "3 2 1 1e9") + bytes, "sizes"));
  CHECK(refuses(replaced(usual, "3 2 1 2", "3 2 1") + bytes, "4 numbers"));
  CHECK(refuses(usual + "spacings: nan 1 -1 1\n" + bytes, "spacing"));
  CHECK(refuses(usual + "space directions: none (1,1,0) (0,1,0) (0,0,1)\n" + bytes, "axes"));
  CHECK(refuses(usual + "nonsense\n" + bytes, "colon"));
  CHECK(refuses(usual, "does not end"));
}

TEST_CASE("damaged NRRD is read or refused, and causes no other failure") {
  const std::string whole = usual + "spacings: NaN 0.5 2 .25\n\n" + data<double>(12);
  test::Random random(6);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes = whole;
    for (int change = 0; change < 3; ++change)
      bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
    if (i % 2 == 0) bytes.resize(random.below(bytes.size()));
    try {
      const FlowGrid grid = read(bytes);
      CHECK(grid.values.size() == 3 * grid.size[0] * grid.size[1] * grid.size[2]);
    } catch (const InputError&) {
    }
  }
}
