#include "io/streams/mapped_file.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"

using namespace transformesh;

TEST_CASE("the bytes are those of the file, also after pages were given back") {
  const test::TemporaryFolder folder;
  const std::string text(100000, 'x');
  test::make_file(folder / "a", text);
  const MappedFile file(folder / "a");
  CHECK(file.bytes() == text);
  file.release();
  CHECK(file.bytes() == text);
}

TEST_CASE("pipes, folders, and empty and missing files are refused at once") {
  const test::TemporaryFolder folder;
  mkfifo((folder / "fifo").c_str(), 0600);
  test::make_file(folder / "empty", "");
  for (const char* name : {"fifo", "empty", "missing", "."})
    CHECK_THROWS_AS(MappedFile(folder / name), InputError);
}
