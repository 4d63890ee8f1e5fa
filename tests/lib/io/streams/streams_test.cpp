#include "io/streams/streams.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <string>
#include <thread>

#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"

using namespace transformesh;
using test::TemporaryFolder;

namespace {

/// Returns bytes without a period that could hide an exchange of blocks.
std::string many_bytes(std::size_t size) {
  std::string bytes(size, '\0');
  std::uint32_t state = 1;
  for (char& byte : bytes) {
    state = 1664525 * state + 1013904223;
    byte = static_cast<char>(state >> 24);
  }
  return bytes;
}

struct Pipe {
  std::array<int, 2> ends{};
  explicit Pipe(int flags = 0) { REQUIRE(pipe2(ends.data(), flags) == 0); }
  std::string path() const { return "/dev/fd/" + std::to_string(ends[0]); }
};

}  // namespace

TEST_CASE("a file is read whole, whatever its size and the bytes in it") {
  const TemporaryFolder folder;
  for (const std::size_t size :
       {0UL, 1UL, (1UL << 20) - 1, 1UL << 20, (1UL << 20) + 1, 3333333UL}) {
    CAPTURE(size);
    const std::string bytes = many_bytes(size);
    test::make_file(folder / "file", bytes);
    CHECK(read_all(folder / "file").view() == bytes);
  }
}

TEST_CASE("data in pieces through a pipe is read and written whole, also without blocking") {
  const std::string bytes = many_bytes(5000001);
  for (const int flags : {0, O_NONBLOCK}) {
    const Pipe pipe(flags);
    bool is_written = false;
    std::thread writer([&] {
      is_written = write_all(pipe.ends[1], std::string_view(bytes).substr(0, 7)) &&
                   write_all(pipe.ends[1], std::string_view(bytes).substr(7));
      close(pipe.ends[1]);
    });
    CHECK(read_all(pipe.path()).view() == bytes);
    writer.join();
    CHECK(is_written);
    close(pipe.ends[0]);
  }
}

TEST_CASE("bytes reserved keep what stood there before") {
  Bytes bytes;
  std::string expected;
  for (std::size_t size = 1; size < 100000; size *= 3) {
    const std::string piece = many_bytes(size);
    piece.copy(bytes.reserve(size), size);
    bytes.grow(size);
    expected += piece;
    CHECK(bytes.view() == expected);
  }
}

TEST_CASE("read and write errors are reported") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH_AS(read_all(folder / "absent"),
                       (folder / "absent: cannot be read: No such file or directory").c_str(),
                       InputError);
  CHECK_THROWS_WITH_AS(read_all(folder / "."),
                       (folder / ".: cannot be read: it is a folder").c_str(), InputError);
  CHECK_THROWS_WITH_AS(read_all(""), "'': cannot be read: No such file or directory", InputError);
  CHECK(input_name("-") == "standard input");

  const Pipe pipe;
  close(pipe.ends[0]);
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  CHECK_FALSE(write_all(pipe.ends[1], "nobody reads this"));
  CHECK(errno == EPIPE);
  std::signal(SIGPIPE, before);
  close(pipe.ends[1]);
  CHECK(write_all(-1, ""));
}
