#include "io/formats/vtk_stream.h"

#include "lib/io/bytes.h"

using namespace transformesh;
using namespace transformesh::testing;

TEST_CASE("vtk stream: words, lines and numbers in turn") {
  const std::string text = "Word OTHER 12\r\nthe rest\n1 2.5 nan\n-3 end";
  const Source source{text, "input"};
  VtkStream stream(source);
  CHECK(stream.word() == "word");
  CHECK(stream.raw_word() == "OTHER");
  CHECK(stream.has_word_in_line());
  CHECK(stream.count("the count") == 12);
  CHECK_FALSE(stream.has_word_in_line());
  stream.line();
  CHECK(stream.line() == "the rest");
  VtkArray array;
  stream.numbers("double", 3, array);
  CHECK(array.values[1] == 2.5);
  CHECK(std::isnan(array.values[2]));
  CHECK_THROWS_WITH_AS(stream.indices("int", 1, "the corners"),
                       doctest::Contains("the corners has an index that is not a whole number"),
                       InputError);
  CHECK(stream.word() == "end");
  CHECK(stream.word().empty());
}

TEST_CASE("vtk stream: bytes are big-endian and start in the next line") {
  Bytes bytes(true);
  bytes.text("short\n").u16(0xfffe).u16(3).text("\nnext");
  const Source source{bytes.str(), "input"};
  VtkStream stream(source);
  stream.set_binary(true);
  VtkArray array;
  stream.numbers(stream.word(), 2, array);
  CHECK(array.values == std::vector<double>{-2, 3});
  CHECK(array.type == Scalar::int16);
  CHECK(stream.word() == "next");
  CHECK_THROWS_WITH_AS(stream.numbers("float", 1, array), doctest::Contains("the data ends within"),
                       InputError);
  CHECK_THROWS_WITH_AS(stream.numbers("bit", 1, array),
                       doctest::Contains("'bit' are not supported"), InputError);
}
