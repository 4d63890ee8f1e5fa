#include "output.h"

#include <doctest/doctest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "helpers/folder.h"
#include "signals.h"

using namespace transformesh;
using namespace transformesh::tool;

TEST_CASE("no output appears until all are committed") {
  const Folder folder;
  make_file(folder / "a", "old");
  Outputs outputs;
  outputs.stage(folder / "a", "new");
  outputs.stage(folder / "b", "other");
  CHECK(content(folder / "a") == "old");
  CHECK_FALSE(std::filesystem::exists(folder / "b"));
  outputs.commit();
  CHECK(content(folder / "a") == "new");
  CHECK(content(folder / "b") == "other");
  CHECK(folder.count() == 2);
}

TEST_CASE("outputs that are not committed leave nothing behind") {
  const Folder folder;
  make_file(folder / "a", "old");
  {
    Outputs outputs;
    outputs.stage(folder / "a", "new");
    CHECK_THROWS_AS(outputs.stage(folder / "none/a", "new"), OutputError);
  }
  CHECK(content(folder / "a") == "old");
  CHECK(folder.count() == 1);
}

TEST_CASE("two outputs of one name are refused") {
  const Folder folder;
  Outputs outputs;
  outputs.stage(folder / "a", "one");
  CHECK_THROWS_AS(outputs.stage(folder / "./a", "two"), UsageError);
}

TEST_CASE("stdout can always be tried") {
  CHECK_NOTHROW(check_output("-"));
  CHECK_THROWS_AS(check_output(""), OutputError);
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
