#include "frame/loop_options.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <filesystem>
#include <system_error>

#include "evolution/loop/record.h"
#include "io/streams/output_target.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

namespace transformesh::tool {

namespace {

// Returns the settings of a run as one line: the inputs, and all options that affect the result. An
// interrupted run can only be continued with the same settings.
std::string settings_of(const Run& run) {
  std::string text;
  for (const std::string& input : run.in().names()) text += '\'' + input + "' ";
  for (const Option& option : run.program().options)
    if (!option.is_common && option.affects_result)
      text += option.name() + " '" + option.text() + "' ";
  text.pop_back();
  return text;
}

// Implements --run FOLDER: all output files get fixed names in this folder. Throws UsageError if an
// option also names one of these files.
void settle_run(Program& program, LoopChoices& choices) {
  std::string& folder = choices.run;
  if (folder.empty()) return;
  const bool finds_events = program.options.find("events") != nullptr;
  std::vector<const char*> names{"output", "format", "frames", "csv", "report"};
  if (finds_events) names.push_back("events");
  for (const char* name : names)
    if (program.options.find(name)->is_given)
      throw UsageError("--run writes all files of a run under fixed names: leave out --" +
                       std::string(name));
  while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  program.common.output = folder + run_file::result;
  program.common.report = folder + run_file::report;
  choices.record.frames = folder + run_file::frames;
  choices.record.csv = folder + run_file::log;
  if (finds_events) choices.record.events = folder + run_file::events;
}

bool is_plain(const std::string& word) {
  return !word.empty() && std::ranges::all_of(word, [](unsigned char character) {
    return std::isalnum(character) != 0 ||
           std::string_view("_-+=.,:/@%").find(static_cast<char>(character)) != std::string::npos;
  });
}

std::string command_of(const Program& program) {
  std::string text = program.name;
  for (std::size_t i = 1; i < program.command.size(); ++i) {
    const std::string& word = program.command[i];
    text += ' ' + (is_plain(word) ? word : shell_word(word));
  }
  return text;
}

}  // namespace

std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char character : text)
    word += character == '\'' ? std::string("'\\''") : std::string(1, character);
  return word + '\'';
}

void declare_iterations(Program& program, LoopChoices& choices, const std::string& help) {
  program.options.integer("iterations", &choices.iterations, 1, 999999999, help).affects_result =
      false;
}

void declare_record(Program& program, LoopChoices& choices, const std::string& every,
                    const std::string& rows) {
  const std::size_t first = program.options.size();
  program.options.flag("resume", &choices.record.resume,
                       "continue an interrupted run, or begin if there is none");
  program.options.flag("restart", &choices.record.restart,
                       "discard an interrupted run, and begin again");
  program.options.text("frames", &choices.record.frames, "FOLDER",
                       "write meshes of the run to this folder, as frame-00000.ply and so on");
  program.options.integer("every", &choices.every, 1, 999999999, every);
  program.options.output_file("csv", &choices.record.csv,
                              "write a CSV file with a line per " + rows);
  program.options.text("run", &choices.run, "FOLDER",
                       "write the files that tm-report shows to this folder: initial mesh, frames, "
                       "log.csv, report.json, result.ply");
  program.options.flag("require-convergence", &choices.require_convergence,
                       "exit with 1 if the result did not converge");
  for (std::size_t i = first; i < program.options.size(); ++i)
    program.options[i].affects_result = false;
  program.settle = [&program, &choices] { settle_run(program, choices); };
}

namespace {

/// Throws UsageError if a frame in the folder is an input, because the run could replace it.
void check_frames(const std::string& folder, const Outputs& out) {
  std::error_code is_missing;
  for (const auto& entry : std::filesystem::directory_iterator(folder, is_missing))
    if (entry.path().filename().string().starts_with(frame_prefix))
      out.check_is_no_input(entry.path().string());
}

}  // namespace

Record open_record(const LoopChoices& choices, long every, Run& run, std::string state) {
  RecordOptions options = choices.record;
  // A run can be continued only if its state can be stored in a file. The place of this file is
  // `state` or, if `state` is empty, beside the output file. If the output is not a regular file,
  // such as stdout, there is no place.
  const bool is_continuable =
      !is_written_directly(end_of_links(run.out().name())) || !state.empty();
  if (options.resume && !is_continuable)
    throw UsageError("--resume continues an output file: name it with -o OUT");
  if (options.resume && options.restart)
    throw UsageError("give either --resume or --restart, not both");
  // If --run is given, all outputs are in its folder. The folder is created later, together with
  // the state, so only check here that it can be used.
  choices.run.empty() ? run.out().check_files(!state.empty()) : check_run_folder(choices.run);
  check_frames(options.frames, run.out());
  const std::string& name = run.program().name;
  report_interruption(name, is_continuable ? "; --resume continues" : "");
  if (state.empty() && is_continuable) state = name_beside(run.out().name(), "", '.' + name);
  options.state = std::move(state);
  options.settings = settings_of(run);
  // The option --events is part of the settings, because only with --events does the stored state
  // of a run contain the labels of components. A run can thus be continued only with the same
  // choice.
  if (!options.events.empty()) options.settings += " events";
  options.every = static_cast<std::size_t>(choices.every.value_or(every));
  options.is_alone = true;
  options.keep_state_at_end = true;
  Record record(options);
  if (is_continuable) run.say().detail("state in " + options.state);
  if (record.resumed()) run.say().detail("continuing after " + std::to_string(record.iteration()));
  return record;
}

void begin_run(const LoopChoices& choices, const Record& record, const Document* start, Run& run,
               RunFiles files) {
  if (choices.run.empty()) return;
  const std::string command = command_of(run.program());
  if (record.resumed()) return continue_run(choices.run, command);
  // The state of an earlier run is removed before its frames and log, because the state is useless
  // without them.
  record.forget_earlier_state();
  if (start != nullptr) {
    Document given = *start;
    given.style.format = Format::ply_little;
    files.emplace_back(run_file::start, transformesh::write_mesh(given).bytes);
  }
  transformesh::begin_run(choices.run, {run.program().name, Run::version(), {command}}, files);
}

LoopOptions loop_of(const LoopChoices& choices, Run& run) {
  return {choices.iterations,
          [&run](const std::string& message) { run.say().progress_line(message); }};
}

Document& begin_document(const Record& record, Run& run) {
  if (record.resumed()) return run.continue_from(record.resumed()->document);
  Document& document = run.read_input();
  run.out().stamp(document);
  return document;
}

void evolve_or_keep(Run& run, const Record& record, const std::string& noun,
                    const std::function<void()>& evolve) {
  try {
    evolve();
  } catch (const std::exception&) {
    if (record.iteration() > 0) {
      const std::string continued = record.has_state() ? "; continue with --resume" : "";
      run.out().keep("stopped in " + noun + ' ' + std::to_string(record.iteration() + 1),
                     "the mesh of " + noun + ' ' + std::to_string(record.iteration()) + continued);
    }
    throw;
  }
}

void conclude(Run& run, const LoopChoices& choices, const Record& record,
              const Conclusion& conclusion) {
  run.out().when_written([&run, record, conclusion] {
    if (conclusion.is_done) record.remove_state();
    run.note(conclusion.summary);
  });
  if (choices.require_convergence && !conclusion.is_converged) run.answer(false);
}

}  // namespace transformesh::tool
