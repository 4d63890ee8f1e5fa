#include "io/streams/expand.h"

#include <zlib.h>

#include "lib/io/bytes.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

/// Returns a member of gzip or, with a window of 15, a stream of zlib.
std::string compressed(const std::string& text, int window = 31) {
  z_stream stream{};
  REQUIRE(deflateInit2(&stream, 9, Z_DEFLATED, window, 9, Z_DEFAULT_STRATEGY) == Z_OK);
  std::string result(text.size() + 1000, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<unsigned>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<unsigned>(result.size());
  REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

}  // namespace

TEST_CASE("gzip: several members, padding and a rest") {
  const std::string two = compressed("first") + compressed(" second");
  CHECK(expand_gzip({two, "input"}).bytes == "first second");
  CHECK(expand_gzip({two + std::string(5, '\0'), "input"}).rest == 0);
  CHECK(expand_gzip({two + "rest", "input"}).rest == 4);
  const std::string text(1000000, 'v');
  CHECK(expand_gzip({compressed(text), "input"}).bytes == text);
}

TEST_CASE("gzip: a mesh is read as if it were not compressed") {
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  CHECK(read_document(compressed(off)).mesh.faces.size() == 1);
  const std::string nameless = off.substr(4);
  CHECK(read_mesh(compressed(nameless), "a.off.gz").document.mesh.faces.size() == 1);
  CHECK(has_note(read_mesh(compressed(off) + "xyz", "input").notes,
                 "gzip: 3 bytes after the compressed data ignored"));
  CHECK(contains(read_error(compressed(compressed(off))), "compressed twice"));
}

TEST_CASE("gzip: damage, a missing end and a bomb") {
  const std::string bytes = compressed("some text that is long enough");
  for (std::size_t size = 2; size < bytes.size(); ++size)
    CHECK(contains(read_error(bytes.substr(0, size)), "the compressed data is "));
  std::string damaged = bytes;
  damaged[bytes.size() - 6] ^= 1;  // in the checksum
  CHECK(contains(read_error(damaged), "damaged"));
  const std::string bomb = compressed(std::string(std::size_t{65} << 20U, '\n'));
  CHECK(contains(read_error(bomb), "expands to more than 64 MB"));
}

TEST_CASE("zlib: streams of a known size") {
  const std::string stream = compressed("0123456789", 15);
  const Source source{stream, "input"};
  CHECK(expand_zlib(source, stream, 10, "x") == "0123456789");
  CHECK_THROWS_WITH_AS(expand_zlib(source, stream, 9, "x"), doctest::Contains("more than 9 bytes"),
                       InputError);
  CHECK_THROWS_WITH_AS(expand_zlib(source, stream.substr(0, 8), 10, "x"),
                       doctest::Contains("x: the compressed data is cut off"), InputError);
  CHECK_THROWS_WITH_AS(expand_zlib(source, "no zlib", 10, "x"), doctest::Contains("damaged"),
                       InputError);
}
