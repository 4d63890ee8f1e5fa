#include "frame/program.h"

#include <unistd.h>

#include <iostream>
#include <new>
#include <stdexcept>

#include "frame/completion.h"
#include "frame/limits.h"
#include "frame/memory.h"
#include "frame/run.h"
#include "io/streams/streams.h"
#include "support/error.h"
#include "support/parallel.h"

namespace transformesh::tool {
namespace {

void prepare_process() {
  // Every word on stderr is a message of the program. Ours do not go through std::cerr, on which
  // CGAL says what it cannot do.
  std::cerr.setstate(std::ios::failbit);
  prepare_streams_and_signals();
}

/// Those named, else stdin.
std::vector<std::string> inputs_of(const Program& program, const std::vector<std::string>& words) {
  if (!program.reads_input() && program.reads != Reads::words && !words.empty())
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

template <typename... Errors>
bool is_any(const std::exception& error) {
  return ((dynamic_cast<const Errors*>(&error) != nullptr) || ...);
}

/// Tells why a run has failed, and returns its exit code.
int tell(const std::exception& error, Terminal& terminal) {
  if (is_any<std::bad_alloc, std::length_error>(error)) {
    terminal.out_of_memory();
    return exit_memory;
  }
  const bool is_reported = is_any<UsageError, InputError, GoalError, OutputError>(error);
  terminal.error(is_reported ? error.what()
                             : "internal error: please report it together with the input");
  return is_any<UsageError>(error)    ? exit_usage
         : is_any<InputError>(error)  ? exit_input
         : is_any<OutputError>(error) ? exit_output
                                      : exit_goal;
}

void declare_common(Program& program) {
  CommonValues& common = program.common;
  const std::size_t own = program.options.size();
  program.text("output,o", &common.output, "FILE", "where to write; - is stdout");
  if (program.may_write_mesh()) {
    program.choice("format", &common.format,
                   {"ply", "ply-ascii", "ply-be", "off", "obj", "stl", "glb", "vtp"},
                   program.is_evolution() ? "format of the output (default ply)"
                                          : "format of the output instead of the input's");
    if (!program.is_evolution()) {
      program.flag("float", &common.as_float, "write coordinates as 32-bit floats");
      program.flag("double", &common.as_double, "write coordinates as 64-bit floats");
    }
    program.flag("no-provenance", &common.no_provenance, "add no comment with the options used");
    if (program.reads_mesh()) program.reference_edge();
  }
  if (program.may_print_report()) program.flag("json", &common.json, "print the report as JSON");
  if (program.reads_points())
    program.flag("strict", &common.strict,
                 "refuse values that are not finite and unknown lines instead of dropping them");
  program.text("report", &common.report, "FILE", "also write a JSON report there");
  program.integer("threads", &common.threads, 0, 1024, "threads to use, 0: one per core");
  program
      .text("max-memory", &common.max_memory, "SIZE",
            "end with exit code 6 rather than take more, such as 2G (default: what there is)")
      .assign = [&common](const std::string& text) {
    parse_size(text);
    common.max_memory = text;
  };
  program
      .number("max-time", &common.max_time, 0, 1e9,
              "end with exit code 4 after so many seconds, 0: never")
      .placeholder = "SECONDS";
  program.flag("progress", &common.progress,
               "report progress on stderr, also where it is not a terminal");
  program.flag("no-progress", &common.no_progress, "never report progress");
  program.flag("quiet,q", &common.quiet, "print errors only");
  program.flag("verbose,v", &common.verbose, "print the settings and what was done");
  program.flag("help,h", &common.help, "print this text");
  program.flag("version", &common.version, "print the version");
  program
      .choice("completion", &common.completion, {"bash", "zsh", "fish"},
              "print a script that completes the command line in this shell")
      .is_listed = false;
  for (std::size_t i = own; i < program.options.size(); ++i) program.options[i].is_common = true;
}

/// What the user asks about the program itself; empty where there is something to do.
std::string about(const Program& program) {
  const CommonValues& common = program.common;
  if (common.help) return help_text(program);
  const std::string commit = TM_COMMIT;
  if (common.version)
    return program.name + " " TM_VERSION + (commit.empty() ? "" : " (commit " + commit + ")") +
           '\n';
  return common.completion.empty() ? "" : completion(program, common.completion);
}

void limit_resources(const CommonValues& values, const std::string& name, Terminal& terminal) {
  std::optional<std::uint64_t> most;
  if (!values.max_memory.empty()) most = parse_size(values.max_memory);
  terminal.set_out_of_memory(limit_memory(name, most));
  if (values.max_time > 0) limit_time(name, values.max_time);
}

}  // namespace

int Program::run(int argc, char** argv, const std::function<void(Run&)>& body) {
  prepare_process();
  Terminal terminal(name);
  std::optional<Run> run;
  try {
    declare_common(*this);
    command.assign(argv, argv + argc);
    const std::vector<std::string> words = parse({argv + 1, argv + argc});
    if (const std::string text = about(*this); !text.empty()) {
      write_file("-", text);
      return exit_done;
    }
    if (settle) settle();
    check_together(common);
    if (reads_input() && words.empty() && isatty(STDIN_FILENO) == 1) {
      // The user wants to know how to use this.
      write_all(STDERR_FILENO, short_help_text(*this));
      return exit_usage;
    }
    inputs = inputs_of(*this, words);
    check_needed(*this);
    // In this order: what the heap takes at once must be within the limit.
    limit_resources(common, name, terminal);
    prepare_memory();
    terminal.configure(common.quiet, common.verbose, common.progress, common.no_progress);
    const ThreadLimit limit(common.threads);
    run.emplace(*this, terminal);
    run->start();
    body(*run);
    return run->finish();
  } catch (const std::exception& error) {
    const int code = tell(error, terminal);
    if (run) run->write_kept();
    return code;
  }
}

}  // namespace transformesh::tool
