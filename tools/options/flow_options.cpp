#include "options/flow_options.h"

#include <algorithm>

#include "flow/flow_notes.h"
#include "flow/grid_files.h"

namespace transformesh::tool {
namespace {

std::string line_of(const FlowKind& kind, std::size_t width) {
  std::string line = kind.name + std::string(width - kind.name.size(), ' ') + "  " + kind.summary;
  for (const std::string& parameter : kind.parameters)
    line += (parameter == kind.parameters.front() ? "; --" : " --") + parameter;
  return line + '\n';
}

}  // namespace

void declare_flow(OptionSet& options, FlowChoices& choices) {
  options.number("speed", &choices.flow.speed, -1e300, 1e300,
                 "factor by which velocities are multiplied");
  options
      .number("period", &choices.period, 0, 1e300,
              "time of one turn of rotation, or period of vortex and deformation (default: "
              "rotation 1, vortex 8, deformation 3)")
      .default_text.clear();
  options.point("center", &choices.flow.center,
                "fixed point of rotation, shear and expansion (default 0.5,0.5,0.5)");
  options.point("direction", &choices.flow.direction,
                "axis of rotation (default 0,0,1), or direction of translation (default 1,0,0)");
  options.text("column", &choices.column, "COLUMN",
               "vertex property by which the speed of the flow normal is multiplied");
  options.text(
      "grid", &choices.grid, "WHERE",
      "files in VTK ImageData or NRRD format: velocities for the flow grid, or speeds for the "
      "flow normal");
  options
      .number("grid-step", &choices.grid_step, 0, 1e300,
              "time between consecutive files of --grid (default: the times in the files)")
      .default_text.clear();
}

std::vector<std::string> flow_names() {
  std::vector<std::string> names;
  for (const FlowKind& kind : flow_kinds()) names.push_back(kind.name);
  return names;
}

std::string flow_list() {
  std::size_t width = 0;
  for (const FlowKind& kind : flow_kinds()) width = std::max(width, kind.name.size());
  std::string text;
  for (const FlowKind& kind : flow_kinds()) text += line_of(kind, width);
  return text;
}

Flow flow_of(const std::string& name, const FlowChoices& choices) {
  FlowOptions options = choices.flow;
  if (choices.period > 0) options.period = choices.period;
  if (!choices.column.empty()) options.column = choices.column;
  options.grids = read_flow_grids(name, choices.grid, choices.grid_step);
  return make_flow(name, std::move(options));
}

void note_flow(const Flow& flow, Run& run) {
  run.report(entries_of(*flow.counts));
  for (const std::string& note : notes_of(*flow.counts)) run.note(note);
}

}  // namespace transformesh::tool
