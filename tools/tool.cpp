#include "tool.h"

#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <iostream>
#include <new>
#include <stdexcept>

#include "command.h"
#include "signals.h"
#include "tm/io/streams.h"
#include "tm/support/error.h"
#include "tm/support/parallel.h"

namespace transformesh::tool {
namespace {

/// Nothing named and a terminal to read from: the user wants to know how to use this.
struct ShortHelpWanted {};

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

/// Those named, else stdin, which must not be a terminal.
std::vector<std::string> inputs_of(const Command& command, const std::vector<std::string>& words) {
  if (command.words != nullptr) return {};
  if (command.reads == Reads::nothing) {
    if (!words.empty()) throw UsageError("'" + words[0] + "' is not expected: there is no input");
    return {};
  }
  if (words.empty()) {
    if (is_terminal(STDIN_FILENO)) throw ShortHelpWanted();
    return {"-"};
  }
  const bool takes_many = command.reads == Reads::meshes || command.reads == Reads::files;
  if (words.size() > 1 && !takes_many)
    throw UsageError("one input at most, but '" + words[1] + "' is a second one");
  return words;
}

void refuse_together(const Command& command, const std::string& first, const std::string& second) {
  if (command.is_given(first) && command.is_given(second))
    throw UsageError("give either --" + first + " or --" + second + ", not both");
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

Program::Program(std::string name, std::string synopsis, std::string summary, Reads reads,
                 Writes writes)
    : command_(std::make_unique<Command>()), terminal_(name) {
  command_->name = std::move(name);
  command_->synopsis = std::move(synopsis);
  command_->summary = std::move(summary);
  command_->reads = reads;
  command_->writes = writes;
}

Program::~Program() = default;

void Program::words(std::vector<std::string>* values, const std::string& placeholder,
                    const std::string& help) {
  command_->words = values;
  command_->words_placeholder = placeholder;
  command_->words_help = help;
}

void Program::keep_out_of_provenance(const std::string& option) {
  command_->find(option)->affects_result = false;
}

void Program::require(const std::string& option) { command_->find(option)->is_needed = true; }

void Program::print_only(const std::string* key) { command_->only_key = key; }

void Program::write_mesh_if(std::function<bool()> condition) {
  command_->writes_mesh_if = std::move(condition);
}

void Program::epilog(std::string text) { command_->epilogs.push_back(std::move(text)); }

void Program::declare_common() {
  CommonValues& values = command_->common;
  command_->declares_common = true;
  text("output,o", &values.output, "FILE", "where to write; - is stdout");
  if (command_->may_write_mesh()) {
    choice("format", &values.format, {"ply", "ply-ascii", "ply-be", "off"},
           command_->is_evolution() ? "format of the output (default ply)"
                                    : "format of the output instead of the input's");
    if (!command_->is_evolution()) {
      flag("float", &values.as_float, "write coordinates as 32-bit floats");
      flag("double", &values.as_double, "write coordinates as 64-bit floats");
    }
    flag("no-provenance", &values.no_provenance, "add no comment with the options used");
    if (command_->reads_mesh())
      reference_edge("",
                     "length that x refers to: measured anew, or set (default: the mesh's "
                     "tm:reference-edge comment, else measured)");
  }
  if (command_->may_print_report()) flag("json", &values.json, "print the report as JSON");
  text("report", &values.report, "FILE", "also write a JSON report there");
  integer("threads", &values.threads, 0, 1024, "threads to use, 0: one per core");
  flag("progress", &values.progress, "report progress on stderr, also where it is not a terminal");
  flag("no-progress", &values.no_progress, "never report progress");
  flag("quiet,q", &values.quiet, "print errors only");
  flag("verbose,v", &values.verbose, "print the settings and what was done");
  flag("help,h", &values.help, "print this text");
  flag("version", &values.version, "print the version");
}

int Program::run(int argc, char** argv, const std::function<void(Run&)>& body) {
  prepare_process();
  try {
    return run_unguarded({argv + 1, argv + argc}, body);
  } catch (const ShortHelpWanted&) {
    write_all(STDERR_FILENO, short_help_text(*command_));
    return exit_usage;
  } catch (...) {
    return tell_failure(terminal_);
  }
}

int Program::run_unguarded(const std::vector<std::string>& arguments,
                           const std::function<void(Run&)>& body) {
  Command& command = *command_;
  declare_common();
  const std::vector<std::string> words = command.parse(arguments);
  if (command.is_given("help")) return print(help_text(command));
  if (command.is_given("version")) return print(command.name + " " TM_VERSION "\n");
  refuse_together(command, "float", "double");
  refuse_together(command, "quiet", "verbose");
  refuse_together(command, "progress", "no-progress");
  if (command.words != nullptr) *command.words = words;
  command.inputs = inputs_of(command, words);
  command.assign();
  const CommonValues& values = command.common;
  if (!values.report.empty() && values.output == values.report)
    throw UsageError("give either --output or --report its own file, not both");
  terminal_.configure(values.quiet, values.verbose, values.progress, values.no_progress);
  const ThreadLimit limit(static_cast<int>(values.threads));
  Run run(command, terminal_);
  try {
    run.start();
    body(run);
  } catch (...) {
    if (!run.kept_) throw;
    const int code = tell_failure(terminal_);
    run.write_kept();
    return code;
  }
  return run.finish();
}

}  // namespace transformesh::tool
