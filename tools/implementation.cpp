#include "implementation.h"

#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <iostream>
#include <new>
#include <stdexcept>

#include "exit_code.h"
#include "output.h"
#include "signals.h"
#include "tm/io/streams.h"
#include "tm/support/error.h"
#include "tm/support/parallel.h"

namespace transformesh::tool {

namespace {

/// Nothing named and a terminal to read from: the user wants to know how to use this.
struct ShortHelpWanted {};

int print(std::string_view text) {
  Outputs().stage("-", text);
  return exit_done;
}

// The inputs to read: those named, else stdin, which must not be a terminal.
std::vector<std::string> inputs(const std::vector<std::string>& named, const Kind& kind) {
  if (!kind.reads_mesh) return {};
  if (named.empty()) {
    if (is_terminal(STDIN_FILENO)) throw ShortHelpWanted();
    return {"-"};
  }
  if (named.size() > 1 && !kind.many_inputs) {
    throw UsageError("one input at most, but '" + named[1] + "' is a second one");
  }
  return named;
}

/// A filter lives for milliseconds: memory given back to the system and taken again costs more of
/// them than it saves, but for large blocks.
void keep_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 16 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
  mallopt(M_TOP_PAD, 4 << 20);
#endif
}

/// Every word on stderr is a message of the program. Ours do not go through std::cerr, on which
/// CGAL says what it cannot do.
void silence_libraries() { std::cerr.setstate(std::ios::failbit); }

}  // namespace

int Program::Implementation::fail(int code, std::string_view message) {
  terminal.error(message);
  return code;
}

void Program::Implementation::check_required() {
  for (const std::string& name : required) {
    const Option* option = table.find(name);
    if (option == nullptr || option->given) continue;
    throw UsageError("--" + option->name + " " + option->placeholder +
                     " is needed: " + option->help);
  }
}

int Program::Implementation::run_unguarded(const std::vector<std::string>& arguments,
                                           const Kind& kind, const Work& work) {
  add_common_options(table, kind, common);
  const std::vector<std::string> positional = table.parse(arguments);
  if (common.help) return print(help_text(description, table, kind));
  if (common.version) return print(description.name + " " TM_VERSION "\n");
  check_common_options(common);
  terminal.configure(common.quiet, common.verbose, common.progress, common.no_progress);
  if (words != nullptr) {
    *words = positional;
  } else if (!kind.reads_mesh && !positional.empty()) {
    throw UsageError("'" + positional[0] + "' is not expected: there is no input");
  }
  const std::vector<std::string> named = inputs(positional, kind);
  check_required();
  const ThreadLimit limit(static_cast<int>(common.threads));
  Session session(description, table, common, terminal);
  return work(session, named);
}

int Program::Implementation::run(int argc, char** argv, const Kind& kind, const Work& work) {
  keep_memory();
  silence_libraries();
  occupy_standard_descriptors();
  install_signal_handlers();
  try {
    return run_unguarded({argv + 1, argv + argc}, kind, work);
  } catch (const ShortHelpWanted&) {
    write_all(STDERR_FILENO, short_help_text(description));
    return exit_usage;
  } catch (const UsageError& error) {
    return fail(exit_usage, error.what());
  } catch (const InputError& error) {
    return fail(exit_input, error.what());
  } catch (const GoalError& error) {
    return fail(exit_goal, error.what());
  } catch (const OutputError& error) {
    return fail(exit_output, error.what());
  } catch (const std::bad_alloc&) {
    write_all(STDERR_FILENO, description.name);
    write_all(STDERR_FILENO, ": out of memory\n");
    return exit_memory;
  } catch (const std::length_error&) {
    return fail(exit_memory, "out of memory");
  } catch (const std::exception&) {
    return fail(exit_goal, "internal error: please report it together with the input");
  }
}

}  // namespace transformesh::tool
