#include "tool.h"

#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <iostream>
#include <limits>
#include <new>
#include <stdexcept>

#include "command.h"
#include "exit_code.h"
#include "help_text.h"
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

void check_required(Command& command) {
  for (const std::string& name : command.required) {
    const Option* option = command.table.find(name);
    if (option == nullptr || option->given) continue;
    throw UsageError("--" + option->name + " " + option->placeholder +
                     " is needed: " + option->help);
  }
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
    : command_(std::make_unique<Command>(
          Command{name, std::move(synopsis), std::move(summary), reads, writes})),
      terminal_(std::move(name)) {}

Program::~Program() = default;

void Program::flag(const std::string& option, bool* value, const std::string& help) {
  command_->table.add(flag_option(option, value, help));
}

void Program::number(const std::string& option, double* value, double minimum, double maximum,
                     const std::string& help) {
  command_->table.add(number_option(option, value, minimum, maximum, help));
}

void Program::integer(const std::string& option, long* value, long minimum, long maximum,
                      const std::string& help) {
  command_->table.add(integer_option(option, value, minimum, maximum, help));
}

void Program::integer(const std::string& option, std::optional<long>* value, long minimum,
                      long maximum, const std::string& help) {
  command_->table.add(integer_option(option, value, minimum, maximum, help));
}

void Program::length(const std::string& option, Length* value, const std::string& help,
                     bool may_be_negative) {
  command_->table.add(length_option(option, value, help, may_be_negative));
}

void Program::length(const std::string& option, std::optional<Length>* value,
                     const std::string& help, bool may_be_negative) {
  command_->table.add(length_option(option, value, help, may_be_negative));
}

void Program::text(const std::string& option, std::string* value, const std::string& placeholder,
                   const std::string& help) {
  command_->table.add(text_option(option, value, placeholder, help));
}

void Program::choice(const std::string& option, std::string* value, std::vector<std::string> names,
                     const std::string& help) {
  command_->table.add(choice_option(option, value, std::move(names), help));
}

void Program::numbers(const std::string& option, std::vector<double>* value,
                      const std::string& placeholder, const std::string& help) {
  command_->table.add(numbers_option(option, value, placeholder, help));
}

void Program::words(std::vector<std::string>* values, const std::string& placeholder,
                    const std::string& help) {
  command_->words = values;
  command_->words_placeholder = placeholder;
  command_->words_help = help;
}

void Program::seed(long* value) {
  integer("seed", value, 0, std::numeric_limits<long>::max(), "seed of the random numbers");
}

void Program::reference_edge(const std::string& value, const std::string& help) {
  command_->common.reference_edge = value;
  command_->table.add(reference_edge_option(&command_->common.reference_edge, help));
}

void Program::keep_out_of_provenance(const std::string& option) {
  if (Option* found = command_->table.find(option)) found->affects_result = false;
}

void Program::require(const std::string& option) { command_->required.push_back(option); }

void Program::print_only(const std::string* key) { command_->only_key = key; }

void Program::epilog(std::string text) { command_->epilogs.push_back(std::move(text)); }

void Program::write_mesh_if(std::function<bool()> condition) {
  command_->writes_mesh_if = std::move(condition);
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
  add_common_options(command);
  const std::vector<std::string> words = command.table.parse(arguments);
  if (command.common.help) return print(help_text(command));
  if (command.common.version) return print(command.name + " " TM_VERSION "\n");
  check_common_options(command.common);
  terminal_.configure(command.common.quiet, command.common.verbose, command.common.progress,
                      command.common.no_progress);
  if (command.words != nullptr) *command.words = words;
  command.inputs = inputs_of(command, words);
  check_required(command);
  const ThreadLimit limit(static_cast<int>(command.common.threads));
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
