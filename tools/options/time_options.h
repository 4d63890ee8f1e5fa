/// Options of evolutions in physical time (evolve_in_time.h), and the motions that they name.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>

#include "frame/run.h"
#include "options/flow_options.h"
#include "transformesh/evolve_in_time.h"

namespace transformesh::tool {

/// Values of the options on the command line.
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

/// Returns the factor in --time-step for an evolution without --time. Throws UsageError for `auto`.
double time_factor(const TimeChoices& choices);

/// Resolves lengths for the mesh of the run. Throws UsageError if a span is not a number.
TimeOptions time_options_of(const TimeChoices& choices, Run& run);

/// Returns the motion that the options name. Flow::counts is set only for flows. `iteration`
/// returns the number of the iteration, which is passed to commands as TM_ITERATION.
Flow motion_of(const TimeChoices& choices, const std::function<std::size_t()>& iteration);

/// Throws UsageError if options of integrators are given for a flow that has its own.
void check_integrator(const Flow& flow, const TimeChoices& choices, const Program& program);

/// Prints notes about steps of a given span that moved vertices far, and about the volume that was
/// not kept.
void note_time(const TimeResult& result, const TimeChoices& choices, Run& run);

}  // namespace transformesh::tool
