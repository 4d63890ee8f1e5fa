#include "options/repair_pipeline.h"

#include <cmath>

#include "mesh/location_text.h"
#include "support/number.h"
#include "support/percent.h"

namespace transformesh::tool {
namespace {

/// A note is printed if a step loses more than this fraction of the area or volume. Users asked for
/// 1 %.
constexpr double large_share = 0.01;

std::string command_of(const StitchOptions& options) {
  std::string command = "tm-stitch";
  if (options.tolerance > 0) command += " --tolerance " + shortest_text(options.tolerance);
  if (options.orient) command += " --orient";
  if (options.drop_copies) command += " --drop-copies";
  if (options.one_side) command += " --one-side";
  if (options.outwards) command += " --outwards";
  return command;
}

std::string command_of(const FillOptions& options) {
  std::string command = "tm-fill --allow-crossings";
  if (!options.fair) command += " --no-fair";
  if (std::isfinite(options.max_diameter))
    command += " --max-diameter " + shortest_text(options.max_diameter);
  return command;
}

std::string command_of(const CleanOptions&) { return "tm-clean"; }

std::string command_of(const SelectionOptions& options) {
  return "tm-select --by area --at-least " + shortest_text(options.at_least);
}

/// Returns the command of a step, such as "tm-fill --allow-crossings".
std::string command_of(const RepairStep& step) {
  return std::visit([](const auto& options) { return command_of(options); }, step.operation);
}

std::string change_text(const char* what, double change) {
  return std::string(", ") + what + (change < 0 ? " " : " +") + significant(change, 3);
}

/// Quotes a word for a shell.
std::string quoted(const std::string& word) {
  const bool is_plain =
      word.find_first_not_of(
          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./+-") ==
      std::string::npos;
  if (is_plain) return word;
  std::string text = "'";
  for (const char character : word) text += character == '\'' ? "'\\''" : std::string(1, character);
  return text + '\'';
}

/// Joins commands by pipes. The first command gets the words `first` and `input`, the last command
/// gets `last`.
std::string joined(const std::vector<std::string>& commands, const std::string& first,
                   const std::string& last, const std::string& input) {
  std::string text;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    text += (i > 0 ? " | " : "") + commands[i];
    if (i == 0) text += first;
    if (i + 1 == commands.size()) text += last;
    if (i == 0) text += input;
  }
  return text;
}

/// Prints a note about a large loss of volume. `volume` is the volume before the step. An open mesh
/// and a mesh that is inside out have no volume to lose. Filling removes nothing: it closes bodies,
/// whose volume is negative if they are still inside out.
void note_volume_loss(const RepairStep& step, double volume, const Run& run) {
  if (!(volume > 0 && -step.volume_change > large_share * volume)) return;
  if (std::holds_alternative<FillOptions>(step.operation)) return;
  const bool cleans = std::holds_alternative<CleanOptions>(step.operation);
  run.note(command_of(step) + " removes " + percent_text(-step.volume_change / volume) +
           " % of the volume" + (cleans ? ", in which overlaps counted once for each part" : "") +
           ", around " + rough_point_text(step.lost_share > 0 ? step.lost_place : step.place));
}

}  // namespace

void note_steps(const RepairResult& result, const Run& run) {
  double volume = result.volume_before;
  for (const RepairStep& step : result.steps) {
    std::string line = command_of(step) + ": ";
    for (const std::string& finding : step.findings) line += finding + ", ";
    line.replace(line.size() - 2, 2, "; at " + rough_point_text(step.place));
    run.note(line + change_text("area", step.area_change) +
             change_text("volume", step.volume_change));
    if (step.lost_share > large_share)
      run.note(command_of(step) + " drops " + percent_text(step.lost_share) +
               " % of the area, most of it around " + rough_point_text(step.lost_place));
    note_volume_loss(step, volume, run);
    volume += step.volume_change;
  }
}

std::string pipeline_of(const RepairResult& result, bool passes_bytes, const Run& run) {
  const CommonValues& common = run.program().common;
  const std::string name = run.in().name();
  const std::string input = name == "-" ? "" : ' ' + quoted(name);
  if (passes_bytes) return "cat" + input;
  std::vector<std::string> commands;
  for (const RepairStep& step : result.steps) commands.push_back(command_of(step));
  if (commands.empty()) commands.emplace_back("tm-convert");
  if (common.no_provenance)
    for (std::string& command : commands) command += " --no-provenance";
  const std::string first = common.as_double ? " --double" : common.as_float ? " --float" : "";
  return joined(commands, first, common.format.empty() ? "" : " --format " + common.format, input);
}

}  // namespace transformesh::tool
