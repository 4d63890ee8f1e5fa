#include "viewer/open_page.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "io/streams/output_target.h"
#include "io/streams/streams.h"
#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

constexpr const char* opener = "xdg-open";

[[noreturn]] void throw_not_opened(const std::string& what, const std::string& why) {
  throw GoalError("'" + what + "' cannot be opened in a browser, as " + opener + ' ' + why +
                  ": open it yourself, or write a page with -o PAGE.html");
}

pid_t start_opener(const std::string& what) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  // Messages of browsers must not appear on the streams of this program.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", 2, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  // The browser runs in its own session, so that Ctrl-C does not end it.
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
  const std::array<const char*, 3> words{opener, what.c_str(), nullptr};
  pid_t child = 0;
  // posix_spawn does not change `words`, although its parameter lacks const.
  // NOLINTNEXTLINE(*-const-cast,*-qualified-auto)
  auto* const arguments = const_cast<char* const*>(words.data());
  const int error = posix_spawnp(&child, opener, &actions, &attributes, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) throw_not_opened(what, "is not installed");
  return child;
}

}  // namespace

std::string write_temporary_page(const std::string& html) {
  std::error_code ignored;
  std::filesystem::path folder = std::filesystem::temp_directory_path(ignored);
  if (ignored) folder = "/tmp";
  constexpr std::string_view ending = ".html";
  std::string path = folder / ("tm-view-XXXXXX" + std::string(ending));
  const int descriptor = mkstemps(path.data(), static_cast<int>(ending.size()));
  if (descriptor < 0) throw_not_written(path);
  const bool is_written = write_all(descriptor, html);
  if (close(descriptor) != 0 || !is_written) {
    unlink(path.c_str());
    throw_not_written(path);
  }
  return path;
}

void open_in_browser(const std::string& what) {
  const pid_t child = start_opener(what);
  // The command may run as long as the browser. Failures occur at once, so a short wait finds them.
  for (int tries = 0; tries < 40; ++tries) {
    int status = 0;
    if (waitpid(child, &status, WNOHANG) == child) {
      if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
      throw_not_opened(what, "fails");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
  }
}

}  // namespace transformesh::tool
