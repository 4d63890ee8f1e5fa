#include "frame/program.h"

#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <iostream>
#include <new>
#include <stdexcept>

#include "frame/run.h"
#include "tm/io/streams.h"
#include "tm/support/error.h"
#include "tm/support/parallel.h"

namespace transformesh::tool {
namespace {

int print(std::string_view text) {
  write_file("-", text);
  return exit_done;
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

void prepare_process() {
  keep_memory();
  // Every word on stderr is a message of the program. Ours do not go through std::cerr, on which
  // CGAL says what it cannot do.
  std::cerr.setstate(std::ios::failbit);
  occupy_standard_descriptors();
  install_signal_handlers();
}

/// Those named, else stdin.
std::vector<std::string> inputs_of(const Program& program, const std::vector<std::string>& words) {
  if (program.reads == Reads::nothing && !words.empty())
    throw UsageError("'" + words[0] + "' is not expected: there is no input");
  if (words.size() > 1 && (program.reads == Reads::mesh || program.reads == Reads::file))
    throw UsageError("one input at most, but '" + words[1] + "' is a second one");
  return words.empty() && program.reads_input() ? std::vector<std::string>{"-"} : words;
}

void check_together(const CommonValues& values) {
  const auto refuse = [](bool are_both, const std::string& either) {
    if (are_both) throw UsageError("give either " + either + ", not both");
  };
  refuse(values.as_float && values.as_double, "--float or --double");
  refuse(values.quiet && values.verbose, "--quiet or --verbose");
  refuse(values.progress && values.no_progress, "--progress or --no-progress");
  refuse(!values.report.empty() && values.output == values.report,
         "--output or --report its own file");
}

void check_needed(const Program& program) {
  for (const Option& option : program.options)
    if (option.is_needed && !option.is_given)
      throw UsageError("--" + option.name() + " " + option.placeholder +
                       " is needed: " + option.help);
}

/// Tells the failure that is being handled, and returns its exit code.
int tell_failure(Terminal& terminal) {
  const auto told = [&terminal](int code, std::string_view message) {
    terminal.error(message);
    return code;
  };
  try {
    throw;
  } catch (const UsageError& error) {
    return told(exit_usage, error.what());
  } catch (const InputError& error) {
    return told(exit_input, error.what());
  } catch (const GoalError& error) {
    return told(exit_goal, error.what());
  } catch (const OutputError& error) {
    return told(exit_output, error.what());
  } catch (const std::bad_alloc&) {
    terminal.out_of_memory();
    return exit_memory;
  } catch (const std::length_error&) {
    return told(exit_memory, "out of memory");
  } catch (const std::exception&) {
    return told(exit_goal, "internal error: please report it together with the input");
  }
}

}  // namespace

Program::Program(std::string its_name, std::string its_synopsis, std::string its_summary,
                 Reads what_it_reads, Writes what_it_writes)
    : name(std::move(its_name)),
      synopsis(std::move(its_synopsis)),
      summary(std::move(its_summary)),
      reads(what_it_reads),
      writes(what_it_writes) {}

void Program::declare_common() {
  const std::size_t own = options.size();
  text("output,o", &common.output, "FILE", "where to write; - is stdout");
  if (may_write_mesh()) {
    choice("format", &common.format, {"ply", "ply-ascii", "ply-be", "off"},
           is_evolution() ? "format of the output (default ply)"
                          : "format of the output instead of the input's");
    if (!is_evolution()) {
      flag("float", &common.as_float, "write coordinates as 32-bit floats");
      flag("double", &common.as_double, "write coordinates as 64-bit floats");
    }
    flag("no-provenance", &common.no_provenance, "add no comment with the options used");
    if (reads_mesh()) reference_edge();
  }
  if (may_print_report()) flag("json", &common.json, "print the report as JSON");
  text("report", &common.report, "FILE", "also write a JSON report there");
  integer("threads", &common.threads, 0, 1024, "threads to use, 0: one per core");
  flag("progress", &common.progress, "report progress on stderr, also where it is not a terminal");
  flag("no-progress", &common.no_progress, "never report progress");
  flag("quiet,q", &common.quiet, "print errors only");
  flag("verbose,v", &common.verbose, "print the settings and what was done");
  flag("help,h", &common.help, "print this text");
  flag("version", &common.version, "print the version");
  for (std::size_t i = own; i < options.size(); ++i) options[i].is_common = true;
}

int Program::run(int argc, char** argv, const std::function<void(Run&)>& body) {
  prepare_process();
  Terminal terminal(name);
  try {
    return run_unguarded({argv + 1, argv + argc}, body, terminal);
  } catch (...) {
    return tell_failure(terminal);
  }
}

int Program::run_unguarded(const std::vector<std::string>& arguments,
                           const std::function<void(Run&)>& body, Terminal& terminal) {
  declare_common();
  const std::vector<std::string> words = parse(arguments);
  if (common.help) return print(help_text(*this));
  if (common.version) return print(name + " " TM_VERSION "\n");
  check_together(common);
  if (reads_input() && words.empty() && is_terminal(STDIN_FILENO)) {
    // The user wants to know how to use this.
    write_all(STDERR_FILENO, short_help_text(*this));
    return exit_usage;
  }
  inputs = inputs_of(*this, words);
  check_needed(*this);
  terminal.configure(common.quiet, common.verbose, common.progress, common.no_progress);
  const ThreadLimit limit(common.threads);
  Run run(*this, terminal);
  try {
    run.start();
    body(run);
  } catch (...) {
    if (!run.kept_) throw;
    const int code = tell_failure(terminal);
    run.write_kept();
    return code;
  }
  return run.finish();
}

}  // namespace transformesh::tool
