#include "output.h"

#include <doctest/doctest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "signals.h"

using namespace transformesh::tool;

namespace {

namespace fs = std::filesystem;

// A folder that is empty at first and gone in the end.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "tm-output-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), {}));
  }

 private:
  fs::path path_;
};

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

void write_file(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

}  // namespace

TEST_CASE("a file keeps its old content until all outputs are committed") {
  const Folder folder;
  write_file(folder / "a", "old");
  Outputs outputs;
  outputs.stage(folder / "a", "new");
  outputs.stage(folder / "b", "other");
  CHECK(content(folder / "a") == "old");
  CHECK_FALSE(fs::exists(folder / "b"));
  outputs.commit();
  CHECK(content(folder / "a") == "new");
  CHECK(content(folder / "b") == "other");
  CHECK(folder.count() == 2);
}

TEST_CASE("what is not committed leaves nothing behind") {
  const Folder folder;
  write_file(folder / "a", "old");
  {
    Outputs outputs;
    outputs.stage(folder / "a", "new");
  }
  CHECK(content(folder / "a") == "old");
  CHECK(folder.count() == 1);
}

TEST_CASE("permissions and symbolic links of a target stay") {
  const Folder folder;
  write_file(folder / "a", "old");
  chmod((folder / "a").c_str(), 0640);
  fs::create_symlink("a", folder / "link");
  Outputs outputs;
  outputs.stage(folder / "link", "new");
  outputs.commit();
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(content(folder / "a") == "new");
  struct stat status {};
  stat((folder / "a").c_str(), &status);
  CHECK((status.st_mode & 07777) == 0640);
}

TEST_CASE("a new file has the permissions that the mask leaves") {
  const Folder folder;
  const mode_t mask = umask(027);
  Outputs outputs;
  outputs.stage(folder / "a", "new");
  outputs.commit();
  umask(mask);
  struct stat status {};
  stat((folder / "a").c_str(), &status);
  CHECK((status.st_mode & 07777) == 0640);
}

TEST_CASE("outputs that cannot work are refused, at once where that can be known") {
  const Folder folder;
  CHECK_THROWS_AS(check_writable(""), OutputError);
  CHECK_THROWS_AS(check_writable(folder / "none/a"), OutputError);
  CHECK_THROWS_AS(check_writable(folder / "."), OutputError);
  CHECK_NOTHROW(check_writable(folder / "a"));
  CHECK_NOTHROW(check_writable("-"));
  Outputs outputs;
  CHECK_THROWS_AS(outputs.stage("/dev/full", "bytes"), OutputError);
  CHECK_THROWS_AS(outputs.stage(folder / "none/a", "bytes"), OutputError);
}

TEST_CASE("a device is written directly and stays a device") {
  Outputs outputs;
  outputs.stage("/dev/null", "bytes");
  outputs.commit();
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("a signal removes what is staged and names itself in the exit code") {
  const Folder folder;
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      install_signal_handlers();
      Outputs outputs;
      outputs.stage(folder / "a", "new");
      outputs.stage(folder / "b", "new");
      raise(number);
      _exit(1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 128 + number);
    CHECK(folder.count() == 0);
  }
}
