/// Common parts of programs that run an evolution (lib/evolution): their options, the files that
/// they write during the run (evolution/loop/record.h), and the end of the run.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "evolution/loop/loop.h"
#include "evolution/loop/record.h"
#include "evolution/loop/run_folder.h"
#include "frame/run.h"

namespace transformesh::tool {

/// Values of the options on the command line.
struct LoopChoices {
  std::size_t iterations = LoopOptions().iterations;
  RecordOptions record;
  std::optional<long> every;
  std::string run;  ///< folder for all output files, from --run FOLDER (run_folder.h)
  bool require_convergence = false;
};

/// Quotes a text so that a shell reads it as one word.
std::string shell_word(const std::string& text);

/// Declares the option --iterations. It is separate from declare_record(), which declares the other
/// options of evolutions, because help texts list these at the end.
void declare_iterations(Program& program, LoopChoices& choices,
                        const std::string& help = "maximum number of iterations");
/// Declares the options for recording and continuing a run, such as --resume, --frames and --csv.
/// `every` is the help text of --every, with its unit and default. `rows` ends the help text of
/// --csv: a noun such as "iteration" for each of which the CSV file gets a line.
void declare_record(Program& program, LoopChoices& choices, const std::string& every,
                    const std::string& rows);

/// Checks that all outputs can be written, and opens the record that stores intermediate results of
/// the run. The state, with which --resume continues an interrupted run, is stored beside the
/// output file, or at `state` if the output is a folder.
Record open_record(const LoopChoices& choices, long every, Run& run, std::string state = {});

/// If --run is given, creates its folder with `files` and with the initial mesh, unless `start` is
/// null. If a run is continued, appends the command line to the description in the folder instead.
/// Must be called after the inputs have been read and before the first iteration.
void begin_run(const LoopChoices& choices, const Record& record, const Document* start, Run& run,
               RunFiles files = {});

/// Returns the limit of iterations, and a function that prints lines of progress.
LoopOptions loop_of(const LoopChoices& choices, Run& run);

/// Returns the mesh with which the run begins or continues, with the format and comments of the
/// output.
Document& begin_document(const Record& record, Run& run);

/// Calls `evolve`. If an iteration fails, the output is the mesh of the last successful iteration,
/// and the error message states this. `noun` is the word for an iteration in this message.
void evolve_or_keep(Run& run, const Record& record, const std::string& noun,
                    const std::function<void()>& evolve);

struct Conclusion {
  /// True: the run is complete; its stored state is removed after all outputs are written.
  bool is_done = false;
  bool is_converged = false;
  std::string summary;  ///< message that is printed at the end of the run
};
/// Ends a run: prints the summary. With --require-convergence, also sets the exit code to 1 if the
/// evolution did not converge.
void conclude(Run& run, const LoopChoices& choices, const Record& record,
              const Conclusion& conclusion);

}  // namespace transformesh::tool
