/// What the programs share that run a loop of evolution (lib/evolution): their options, the
/// record of the run beside its output, and what becomes of it at the end.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "evolution/loop/loop.h"
#include "evolution/loop/run_folder.h"
#include "frame/run.h"

namespace transformesh::tool {

/// Options as they are written.
struct LoopChoices {
  std::size_t iterations = LoopOptions().iterations;
  RecordOptions record;
  std::optional<long> every;
  std::string run;  ///< folder (run_folder.h)
  bool require_convergence = false;
};

/// In quotes, as a shell reads it back as one word.
std::string shell_word(const std::string& text);

/// --iterations; then, after the program's own options, the rest.
void declare_iterations(Program& program, LoopChoices& choices);
/// `every` says what --every counts and its default.
void declare_record(Program& program, LoopChoices& choices, const std::string& every,
                    const std::string& rows);

/// Checks that all outputs can be written, and looks for a state: beside the output, or in `state`
/// where the output is a folder.
Record open_record(const LoopChoices& choices, long every, Run& run, std::string state = {});

/// Where there is --run: begins it with the start, if there is one, and these files, or adds the
/// command to one that continues. To be called once inputs have been read, before the loop begins.
void begin_run(const LoopChoices& choices, const Record& record, const Document* start, Run& run,
               RunFiles files = {});

/// The limit, and lines of progress.
LoopOptions loop_of(const LoopChoices& choices, Run& run);

/// The mesh with which the run begins, or continues, as -o shall hold it.
Document& begin_document(const Record& record, Run& run);

/// Calls `evolve`. Where that fails after `noun` 1 or later, the output holds the last good mesh,
/// and the message states so.
void evolve_or_keep(Run& run, const Record& record, const std::string& noun,
                    const std::function<void()>& evolve);

struct Conclusion {
  bool is_done = false;  ///< leaves no state once the outputs are written
  bool is_converged = false;
  std::string summary;  ///< said then
};
/// Answers --require-convergence as well.
void conclude(Run& run, const LoopChoices& choices, const Record& record,
              const Conclusion& conclusion);

}  // namespace transformesh::tool
