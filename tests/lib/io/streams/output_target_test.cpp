#include "io/streams/output_target.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <filesystem>

#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::test;

namespace fs = std::filesystem;

TEST_CASE("links are followed to their end, which need not be there, or to a descriptor") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "far");
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("far/c", folder / "b");
  fs::create_symlink("../d", folder / "far/c");
  CHECK(is_same_place(end_of_links(folder / "a"), folder / "d"));
  CHECK(end_of_links(folder / "d") == folder / "d");
  CHECK(end_of_links("-") == "-");
  fs::create_symlink("/dev/fd/9", folder / "pipe");
  CHECK(end_of_links(folder / "pipe") == "/dev/fd/9");
  fs::create_symlink("circle", folder / "circle");
  CHECK_THROWS_AS(end_of_links(folder / "circle"), OutputError);
}

TEST_CASE("names beside a path have 255 bytes at most, whole characters, and differ") {
  CHECK(name_beside("a/b", ".", ".tmp") == "a/.b.tmp");
  CHECK(name_beside("b", "", ".x") == "b.x");
  std::string accents = "a";  // shifts the limit into the middle of a character
  for (int i = 0; i < 126; ++i) accents += "\xc3\xa9";
  for (const std::string& name : {std::string(255, 'x'), accents, "a" + accents}) {
    const std::string beside = name_beside("folder/" + name, ".", ".123-0.tmp").substr(7);
    CHECK(beside.size() <= 255);
    CHECK(beside.size() > 250);
    CHECK(beside.ends_with(".123-0.tmp"));
  }
  const std::string beside = name_beside(accents, "", ".state");
  const std::size_t number = beside.find_first_of("0123456789");
  CHECK(beside[number - 1] == '\xa9');
  std::string first(251, 'x'), second = first;
  first.back() = 'y';
  second.back() = 'z';
  CHECK(name_beside(first, "", ".state") != name_beside(second, "", ".state"));
}

TEST_CASE("an open descriptor is written where it stands") {
  const TemporaryFolder folder;
  make_file(folder / "log", "before ");
  const int log = open((folder / "log").c_str(), O_WRONLY | O_APPEND);
  const std::string name = "/dev/fd/" + std::to_string(log);
  CHECK(is_written_directly(name));
  const int copy = open_directly(name);
  CHECK(copy != log);
  CHECK(write(copy, "after", 5) == 5);
  close(copy);
  close(log);
  CHECK(content_of(folder / "log") == "before after");
  CHECK_THROWS_AS(open_directly(name), OutputError);
}
