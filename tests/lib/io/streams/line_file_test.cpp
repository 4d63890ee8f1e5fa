#include "io/streams/line_file.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::test;

TEST_CASE("a file begins anew and grows by lines") {
  const TemporaryFolder folder;
  make_file(folder / "log", "old\nold\nold\n");
  const LineFile file(folder / "log", "header\n");
  CHECK(content_of(folder / "log") == "header\n");
  file.append("1,2");
  CHECK(content_of(folder / "log") == "header\n1,2\n");
}

TEST_CASE("a FIFO stays open between lines") {
  const TemporaryFolder folder;
  mkfifo((folder / "pipe").c_str(), 0600);
  const int reader = open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
  const LineFile file(folder / "pipe", "a\n");
  std::string bytes(2, ' ');
  CHECK(read(reader, bytes.data(), 2) == 2);
  // At the end of the file, read() would return 0.
  CHECK(read(reader, bytes.data(), 2) == -1);
  file.append("b");
  CHECK(read(reader, bytes.data(), 2) == 2);
  CHECK(bytes == "b\n");
  close(reader);
}

TEST_CASE("a full disk is reported") {
  CHECK_THROWS_AS(LineFile("/dev/full", "header\n"), OutputError);
  CHECK_THROWS_AS(LineFile("none/log", "header\n"), OutputError);
}
