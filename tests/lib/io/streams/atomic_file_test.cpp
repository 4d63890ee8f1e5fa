#include "io/streams/atomic_file.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "helpers/temporary_folder.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

namespace fs = std::filesystem;

mode_t mode_of(const std::string& path) {
  struct stat status {};
  stat(path.c_str(), &status);
  return status.st_mode & 07777;
}

std::string message_of(const std::string& path) {
  try {
    write_file(path, "bytes");
    return {};
  } catch (const OutputError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("a file keeps its old content until the new one is committed") {
  const TemporaryFolder folder;
  make_file(folder / "a", "old");
  AtomicFile file(folder / "a", "new");
  CHECK(content_of(folder / "a") == "old");
  CHECK(folder.count() == 2);
  file.commit();
  CHECK(content_of(folder / "a") == "new");
  CHECK(folder.count() == 1);
}

TEST_CASE("a file that is not committed leaves nothing behind, wherever it was moved") {
  const TemporaryFolder folder;
  make_file(folder / "a", "old");
  {
    AtomicFile file(folder / "a", "new");
    const AtomicFile moved(std::move(file));
  }
  CHECK(content_of(folder / "a") == "old");
  CHECK(folder.count() == 1);
}

TEST_CASE("permissions and symbolic links of a target stay") {
  const TemporaryFolder folder;
  make_file(folder / "a", "old");
  chmod((folder / "a").c_str(), 0640);
  fs::create_symlink("a", folder / "link");
  write_file(folder / "link", "new");
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(content_of(folder / "a") == "new");
  CHECK(mode_of(folder / "a") == 0640);
}

TEST_CASE("a link to where no file is yet stays a link") {
  const TemporaryFolder folder;
  fs::create_symlink("a", folder / "link");
  write_file(folder / "link", "new");
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(content_of(folder / "a") == "new");
}

TEST_CASE("a new file has the permissions that the mask leaves") {
  const TemporaryFolder folder;
  const mode_t mask = umask(027);
  write_file(folder / "a", "new");
  umask(mask);
  CHECK(mode_of(folder / "a") == 0640);
}

TEST_CASE("a temporary file of another run is not touched") {
  const TemporaryFolder folder;
  const std::string other = folder / (".a." + std::to_string(getpid()) + "-0.tmp");
  make_file(other, "other");
  write_file(folder / "a", "new");
  CHECK(content_of(folder / "a") == "new");
  CHECK(content_of(other) == "other");
}

TEST_CASE("output that cannot be written is refused, at once if possible") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(check_writable(""), OutputError);
  CHECK_THROWS_AS(check_writable(folder / "none/a"), OutputError);
  CHECK_THROWS_AS(check_writable(folder / "."), OutputError);
  CHECK_NOTHROW(check_writable(folder / "a"));
  CHECK_NOTHROW(check_writable("-"));
  CHECK(message_of("/dev/full") == "cannot write '/dev/full': No space left on device");
  CHECK(message_of(folder / "none/a") ==
        "cannot write '" + folder / "none/a" + "': No such file or directory");
}

TEST_CASE("devices and pipes are written directly and stay what they are") {
  const TemporaryFolder folder;
  write_file("/dev/null", "bytes");
  CHECK(fs::is_character_file("/dev/null"));
  mkfifo((folder / "pipe").c_str(), 0600);
  const int reader = open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
  AtomicFile(folder / "pipe", "bytes").commit();
  std::string bytes(5, ' ');
  CHECK(read(reader, bytes.data(), 5) == 5);
  CHECK(bytes == "bytes");
  CHECK(folder.count() == 1);
  close(reader);
}

TEST_CASE("two files have the same target, however it is named") {
  const TemporaryFolder folder;
  fs::create_symlink("a", folder / "link");
  const AtomicFile file(folder / "a", "one");
  CHECK(file.place() == AtomicFile(folder / "link", "two").place());
  CHECK(file.place() != AtomicFile(folder / "b", "two").place());
}

TEST_CASE("uncommitted files are removed when the process is ended") {
  const TemporaryFolder folder;
  AtomicFile first(folder / "a", "new");
  write_file(folder / "b", "new");
  const AtomicFile third(folder / "c", "new");
  remove_temporary_files();
  CHECK(folder.count() == 1);
  CHECK(content_of(folder / "b") == "new");
  CHECK_THROWS_AS(first.commit(), OutputError);
}

TEST_CASE("a growing file appears when it is committed, and is removed otherwise") {
  const TemporaryFolder folder;
  {
    AtomicFile file(folder / "a");
    file.append("one ");
    AtomicFile moved(std::move(file));
    moved.append("two");
    moved.finish();
    CHECK(content_of(folder / "a").empty());
    moved.commit();
  }
  CHECK(content_of(folder / "a") == "one two");
  { AtomicFile(folder / "b").append("lost"); }
  CHECK(folder.count() == 1);
  AtomicFile full("/dev/full");
  CHECK_THROWS_AS(full.append("bytes"), OutputError);
}
