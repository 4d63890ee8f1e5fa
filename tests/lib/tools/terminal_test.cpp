#include "frame/terminal.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <functional>

using namespace transformesh::tool;
using namespace std::chrono_literals;

namespace {

// Returns the output of these calls on stderr.
std::string printed(const std::function<void(Terminal&)>& calls) {
  std::FILE* file = std::tmpfile();
  REQUIRE(file != nullptr);
  const int saved = dup(STDERR_FILENO);
  dup2(fileno(file), STDERR_FILENO);
  {
    Terminal terminal("tm-x");
    calls(terminal);
  }
  dup2(saved, STDERR_FILENO);
  close(saved);
  std::array<char, 4096> text{};
  const ssize_t size = pread(fileno(file), text.data(), text.size(), 0);
  std::fclose(file);
  return {text.data(), static_cast<std::size_t>(size)};
}

}  // namespace

TEST_CASE("messages are single lines with the program's name") {
  CHECK(printed([](Terminal& terminal) {
          terminal.error("broken\nin two");
          terminal.note("by the way");
          terminal.detail("only with -v");
        }) == "tm-x: broken in two\ntm-x: by the way\n");
}

TEST_CASE("-q leaves errors only, -v adds details") {
  CHECK(printed([](Terminal& terminal) {
          terminal.configure(true, false, false, false);
          terminal.error("one");
          terminal.note("two");
        }) == "tm-x: one\n");
  CHECK(printed([](Terminal& terminal) {
          terminal.configure(false, true, false, false);
          terminal.note("one");
          terminal.detail("two");
        }) == "tm-x: one\ntm-x: two\n");
}

TEST_CASE("if stderr is no terminal, progress is shown only if requested") {
  const auto calls = [](bool progress, bool no_progress) {
    return printed([=](Terminal& terminal) {
      terminal.configure(false, false, progress, no_progress);
      const auto start = Terminal::Clock::now();
      for (int second = 0; second <= 12; ++second) {
        terminal.progress("splitting", second / 12.0, start + second * 1s);
      }
    });
  };
  CHECK(calls(false, false) == "");
  CHECK(calls(false, true) == "");
  CHECK(calls(true, false) == "tm-x: splitting 42%\ntm-x: splitting 83%\n");
}

TEST_CASE("a bar appears after a while, is redrawn at most ten times a second, and disappears") {
  const std::string text = printed([](Terminal& terminal) {
    terminal.set_progress_style(ProgressStyle::bar);
    const auto start = Terminal::Clock::now();
    for (int i = 0; i <= 25; ++i) terminal.progress("flipping", i / 50.0, start + 10s + i * 10ms);
    terminal.note("done");
  });
  const std::string erase = "\r\033[K";
  const std::string empty = erase + "tm-x: [------------------------------] 0% flipping";
  CHECK(text.starts_with(empty + erase + "tm-x: [######------------------------] 20% flipping"));
  CHECK(text.ends_with(erase + "tm-x: done\n"));
  std::size_t redraws = 0;
  for (std::size_t at = 0; (at = text.find("flipping", at)) != std::string::npos; ++at) ++redraws;
  CHECK(redraws == 3);
}

TEST_CASE("lines of progress are shown if requested, and never with -q") {
  const auto calls = [](bool quiet, bool progress) {
    return printed([=](Terminal& terminal) {
      terminal.configure(quiet, false, progress, false);
      terminal.progress_line("iteration 1");
      terminal.progress_line("iteration 2");
    });
  };
  CHECK(calls(false, false) == "");
  CHECK(calls(true, true) == "");
  CHECK(calls(false, true) == "tm-x: iteration 1\ntm-x: iteration 2\n");
  CHECK(printed([](Terminal& terminal) {
          terminal.set_progress_style(ProgressStyle::bar);
          terminal.progress_line("iteration 1");
          terminal.error("broken");
        }) == "\r\033[Ktm-x: iteration 1\r\033[Ktm-x: broken\n");
}
