/// Options that choose a flow (flow.h) and set its parameters.
#pragma once

#include <string>
#include <vector>

#include "frame/run.h"
#include "transformesh/flow.h"

namespace transformesh::tool {

/// Values of the options on the command line. Values that need no conversion are stored in `flow`.
/// The others are converted by flow_of().
struct FlowChoices {
  FlowOptions flow;
  double period = 0;  ///< period of the flow; 0: default of the flow
  std::string column;
  /// Files of grids with velocities or speeds: a file, a folder or a shell pattern (file_list.h).
  std::string grid;
  double grid_step = 0;  ///< time between consecutive files; 0: the files state their times
};

/// Declares --speed, --period, --center, --direction, --column, --grid and --grid-step.
void declare_flow(OptionSet& options, FlowChoices& choices);

std::vector<std::string> flow_names();
/// Returns one line for each flow: its name, its motion and its options.
std::string flow_list();

/// Returns the flow of this name. Throws UsageError for options that the flow does not have.
Flow flow_of(const std::string& name, const FlowChoices& choices);

/// Reports for a flow that is interpolated from grids: the numbers of vertices outside of the grids
/// and of fixed vertices. Prints notes about vertices, and about times, that the grids do not
/// cover.
void note_flow(const Flow& flow, Run& run);

}  // namespace transformesh::tool
