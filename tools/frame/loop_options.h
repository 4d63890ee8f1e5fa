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
  std::string run;  ///< folder of --run (run_folder.h)
  bool require_convergence = false;
};

/// Quotes a text so that a shell reads it as one word.
std::string shell_word(const std::string& text);

/// Declares --iterations. declare_record() declares the other options of loops, after the options
/// of the program.
void declare_iterations(Program& program, LoopChoices& choices,
                        const std::string& help = "maximum number of iterations");
/// Declares the options for recording and continuing a run, such as --resume, --frames and --csv.
/// `every` is the help of --every, with its unit and default. `rows` completes the help of --csv:
/// the event for which a row is written.
void declare_record(Program& program, LoopChoices& choices, const std::string& every,
                    const std::string& rows);

/// Checks that all outputs can be written, and opens the record of the run. The state, with which
/// --resume continues the run, is stored beside the output file, or at `state` if the output is a
/// folder.
Record open_record(const LoopChoices& choices, long every, Run& run, std::string state = {});

/// Begins the run folder of --run with the initial mesh, if there is one, and `files`. If a run is
/// continued, adds the command to its description. Does nothing without --run. Must be called after
/// the inputs have been read and before the loop begins.
void begin_run(const LoopChoices& choices, const Record& record, const Document* start, Run& run,
               RunFiles files = {});

/// Returns the limit of iterations, and a function that prints lines of progress.
LoopOptions loop_of(const LoopChoices& choices, Run& run);

/// Returns the mesh with which the run begins or continues, with the format and comments of the
/// output.
Document& begin_document(const Record& record, Run& run);

/// Calls `evolve`. If an iteration fails, the output is the mesh of the last successful iteration,
/// and the error message states this. `noun` is the word for an iteration.
void evolve_or_keep(Run& run, const Record& record, const std::string& noun,
                    const std::function<void()>& evolve);

struct Conclusion {
  bool is_done = false;  ///< true: the state is removed after the outputs are written
  bool is_converged = false;
  std::string summary;  ///< message at the end
};
/// Ends a run: prints the summary, and sets the exit code for --require-convergence.
void conclude(Run& run, const LoopChoices& choices, const Record& record,
              const Conclusion& conclusion);

}  // namespace transformesh::tool
