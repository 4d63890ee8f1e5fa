#include "frame/program.h"

#include <unistd.h>

#include <iostream>
#include <new>
#include <stdexcept>

#include "frame/advice.h"
#include "frame/completion.h"
#include "frame/limits.h"
#include "frame/memory.h"
#include "frame/run.h"
#include "io/streams/streams.h"
#include "support/parallel.h"
#include "support/suggestion.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

void prepare_process() {
  // Silences std::cerr, on which CGAL prints. Messages of the programs do not use it.
  std::cerr.setstate(std::ios::failbit);
  prepare_streams_and_signals();
}

/// Moves the first word, which is the command, from `words` to the program.
void take_command(Program& program, std::vector<std::string>& words) {
  if (!program.has_command()) return;
  check_command(program, words);
  program.word = words[0];
  words.erase(words.begin());
}

/// Returns the names of the inputs, or `-` if no input is named.
std::vector<std::string> inputs_of(const Program& program, const std::vector<std::string>& words) {
  if (!program.reads_input() && program.input.reads != Reads::words && !words.empty())
    throw UsageError("'" + words[0] + "' is unexpected: no input is read with these options");
  if (words.size() > 1 &&
      (program.input.reads == Reads::mesh || program.input.reads == Reads::file))
    throw UsageError("at most one input can be given, but '" + words[1] + "' is a second one");
  return words.empty() && program.reads_input() ? std::vector<std::string>{"-"} : words;
}

void check_together(const CommonValues& values) {
  const auto refuse = [](bool are_both, const std::string& either) {
    if (are_both) throw UsageError("give either " + either + ", not both");
  };
  refuse(values.as_float && values.as_double, "--float or --double");
  refuse(values.quiet && values.verbose, "--quiet or --verbose");
  refuse(values.progress && values.no_progress, "--progress or --no-progress");
  if (values.output == "-" && values.report == "-")
    throw UsageError("two outputs would go to standard output: name a file for one of them");
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

/// Prints the error of a failed run, and returns its exit code.
int tell(const std::exception& error, const Program& program, Terminal& terminal) {
  if (is_any<std::bad_alloc, std::length_error>(error)) {
    terminal.out_of_memory();
    return exit_memory;
  }
  const auto* own = dynamic_cast<const Error*>(&error);
  terminal.error(own != nullptr ? with_advice(own->problem(), program)
                                : "internal error: please report it together with the input");
  return is_any<UsageError>(error)    ? exit_usage
         : is_any<InputError>(error)  ? exit_input
         : is_any<OutputError>(error) ? exit_output
                                      : exit_goal;
}

void declare_common(Program& program) {
  CommonValues& common = program.common;
  OptionSet& options = program.options;
  const std::size_t own = options.size();
  options.output_file("output,o", &common.output, "output file; - is stdout");
  if (program.may_write_mesh()) {
    options.choice("format", &common.format,
                   {"ply", "ply-ascii", "ply-be", "off", "obj", "stl", "glb", "vtp", "3mf", "xyz"},
                   program.reads_mesh() && !program.is_evolution()
                       ? "format of the output (default: by the ending of -o, else as the input)"
                       : "format of the output (default: by the ending of -o, else ply)");
    if (!program.is_evolution()) {
      options.flag("float", &common.as_float, "write coordinates as 32-bit floats");
      options.flag("double", &common.as_double, "write coordinates as 64-bit floats");
    }
    options.flag("no-provenance", &common.no_provenance,
                 "do not add a comment with the options used");
    if (program.reads_mesh()) program.reference_edge();
  }
  if (program.may_print_report()) {
    options.flag("json", &common.json, "print the report as JSON");
    if (options.find("get") == nullptr)
      options.text("get", &common.get, "KEY", "print only the value of this key of the report");
  }
  if (program.reads_points())
    options.flag(
        "strict", &common.strict,
        "refuse values that are not finite and unknown lines (default: drop and report them)");
  if (program.input.may_keep_polygons)
    options.flag("keep-polygons", &common.keep_polygons,
                 "do not split polygons into triangles; PLY, OFF and OBJ can store polygons");
  options.output_file("report", &common.report, "write a JSON report to this file");
  options.integer("threads", &common.threads, 0, 1024, "number of threads; 0: one per core");
  options
      .text("max-memory", &common.max_memory, "SIZE",
            "memory limit, such as 2G; exit with 6 if more is needed (default: memory of the "
            "machine)")
      .assign = [&common](const std::string& text) {
    parse_size(text);
    common.max_memory = text;
  };
  options
      .number("max-time", &common.max_time, 0, 1e9,
              "time limit; exit with 4 after this many seconds; 0: no limit")
      .placeholder = "SECONDS";
  options.flag("progress", &common.progress,
               "report progress on stderr even if it is not a terminal");
  options.flag("no-progress", &common.no_progress, "do not report progress");
  options.flag("quiet,q", &common.quiet, "print errors only");
  options.flag("verbose,v", &common.verbose, "print the settings and what was done");
  options.flag("help,h", &common.help, "print this text");
  options.flag("version", &common.version, "print the version");
  options
      .choice("completion", &common.completion, {"bash", "zsh", "fish"},
              "print a script that completes the command line in this shell")
      .is_listed = false;
  for (std::size_t i = own; i < options.size(); ++i) options[i].is_common = true;
}

/// Returns the text for --help, --version and similar options. Returns an empty text if none of
/// them is given.
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

// True if an option is part of the provenance. Of the common options, only a few affect the result.
bool is_in_provenance(const Option& option) {
  for (const char* file : {"FILE", "FOLDER", "WHERE"})
    if (option.placeholder.find(file) != std::string::npos) return false;
  const std::string name = option.name();
  const bool changes_meaning = name == "float" || name == "double" || name == "reference-edge";
  return option.is_given && option.affects_result && (!option.is_common || changes_meaning);
}

// Quotes a word for a shell. Replaces control characters, because the word becomes part of a
// one-line comment of the output, which a line break would end.
std::string provenance_word(std::string word) {
  for (char& character : word) {
    if (static_cast<unsigned char>(character) < ' ' || character == '\x7f') character = '?';
  }
  const bool is_plain = !word.empty() && word.find_first_of(" '\"\\$`*?") == std::string::npos;
  return is_plain ? word : "'" + word + "'";
}

}  // namespace

Option& Program::reference_edge() {
  return options.reference_edge(
      &common.reference_edge,
      is_evolution() ? "length of the unit x; auto: mean edge length of the source (default: its "
                       "tm:reference-edge comment, else auto)"
                     : "length of the unit x; auto: mean edge length of the mesh (default: its "
                       "tm:reference-edge comment, else auto)");
}

void check_command(const Program& program, const std::vector<std::string>& words) {
  const std::vector<std::string>& commands = program.words.choices;
  std::string listed;
  for (const std::string& command : commands) listed += (listed.empty() ? "" : ", ") + command;
  if (words.empty())
    throw UsageError("the command is missing: give one of " + listed + "; see --help");
  const std::string nearest = nearest_name(words[0], commands);
  if (nearest != words[0])
    throw UsageError("unknown command '" + words[0] + "'" +
                     (is_near(words[0], nearest) ? "; did you mean '" + nearest + "'?"
                                                 : ": it is one of " + listed));
}

std::string provenance(const Program& program) {
  std::string line = program.name + " " TM_VERSION;
  if (!program.word.empty()) line += ' ' + program.word;
  if (program.input.reads == Reads::words)
    for (const std::string& word : program.inputs) line += ' ' + provenance_word(word);
  for (const Option& option : program.options) {
    if (!is_in_provenance(option)) continue;
    line += " --" + option.name();
    if (!option.is_flag()) line += ' ' + provenance_word(option.text());
  }
  return line;
}

int Program::run(int argc, char** argv, const std::function<void(Run&)>& body) {
  prepare_process();
  Terminal terminal(name);
  std::optional<Run> run;
  try {
    declare_common(*this);
    command.assign(argv, argv + argc);
    std::vector<std::string> arguments = options.parse({argv + 1, argv + argc});
    if (const std::string text = about(*this); !text.empty()) {
      write_file("-", text);
      return exit_done;
    }
    if (settle) settle();
    check_together(common);
    if (reads_input() && arguments.empty() && isatty(STDIN_FILENO) == 1) {
      // Without arguments, the program prints a short help.
      write_all(STDERR_FILENO, short_help_text(*this));
      return exit_usage;
    }
    take_command(*this, arguments);
    inputs = inputs_of(*this, arguments);
    check_needed(*this);
    // The limits are set before prepare_memory(), because the memory limit also applies to the heap
    // that prepare_memory() reserves.
    limit_resources(common, name, terminal);
    prepare_memory();
    terminal.configure(common.quiet, common.verbose, common.progress, common.no_progress);
    const ThreadLimit limit(common.threads);
    run.emplace(*this, terminal);
    run->start();
    body(*run);
    return run->finish();
  } catch (const std::exception& error) {
    // The reason comes last, because callers often show only the last line.
    if (run) run->out().write_kept();
    return tell(error, *this, terminal);
  }
}

}  // namespace transformesh::tool
