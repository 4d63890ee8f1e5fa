/// Options of evolutions in physical time (evolve_in_time.h), and the motions that they name.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>

#include "frame/run.h"
#include "options/flow_options.h"
#include "transformesh/evolve_in_time.h"

namespace transformesh::tool {

/// Values of the options on the command line. Values that need no conversion are stored in
/// `options`. The others are converted by time_options_of().
struct TimeChoices {
  double end = 0;  ///< end time; 0: the evolution is not in physical time
  std::string velocity, flow;
  FlowChoices flow_options;
  bool persistent = false;
  std::string span;
  TimeOptions options;
  std::optional<Length> tolerance;
  std::string contact = "gap:0.05x";
};

void declare_time(Program& program, TimeChoices& choices);

/// Names of the options that need --time.
std::initializer_list<const char*> time_option_names();

/// Throws UsageError unless the options name exactly one motion.
void check_time(const TimeChoices& choices);

/// Returns the value of --time-step for an evolution without --time: the factor by which velocities
/// are multiplied. Throws UsageError for `auto`.
double time_factor(const TimeChoices& choices);

/// Returns the options of the library, with lengths resolved for the mesh of the run. Throws
/// UsageError if --time-step is neither `auto` nor a positive number.
TimeOptions time_options_of(const TimeChoices& choices, Run& run);

/// Returns the motion that the options name: a flow or a command. Flow::counts is set only for
/// flows. `iteration` returns the number of the iteration, which is passed to commands in the
/// environment variable TM_ITERATION.
Flow motion_of(const TimeChoices& choices, const std::function<std::size_t()>& iteration);

/// Throws UsageError if --integrator or --tolerance is given for a flow that has implicit steps of
/// its own.
void check_integrator(const Flow& flow, const TimeChoices& choices, const Program& program);

/// Prints a note if --time-step is a number and a step moved a vertex by more than a mean edge.
/// Prints a note if the volume could not be kept.
void note_time(const TimeResult& result, const TimeChoices& choices, Run& run);

}  // namespace transformesh::tool
