/// The options of tm-reconstruct, and their conversion to options of the library.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "frame/loop_options.h"
#include "frame/run.h"
#include "options/color_options.h"
#include "options/view_options.h"
#include "reconstruction/sequence.h"
#include "reconstruction/time_steps.h"
#include "views/cameras/view.h"
#include "views/cameras/view_files.h"

namespace transformesh::tool {

/// Values of the options on the command line. Values that need no conversion are stored in
/// `options`. The others are converted by reconstruction_of().
struct ReconstructChoices {
  ViewSources sources;
  ReconstructionOptions options;
  std::string threshold;
  std::string keep = "auto";
  std::string sequence;
  double track = SequenceOptions().track;
  std::string coarsest = "auto";
  std::string last_edge;
  std::string iterations = "auto";
  std::optional<Box> box;
  bool is_preview = false;
  std::string window = "3";
  std::string pull = "auto";
  ViewCheckChoices check;
  bool is_colored = false;
  ColorChoices color;
  LoopChoices loop;
};

void declare_reconstruction(Program& program, ReconstructChoices& choices);

/// Returns the options of reconstruct(). Throws UsageError for invalid values and inconsistent
/// options.
ReconstructionOptions reconstruction_of(const ReconstructChoices& choices, Run& run);

/// Returns the options for the reconstruction of a sequence of time steps, except
/// SequenceOptions::comments. Throws UsageError if the paths of inputs do not depend on the time
/// step.
SequenceOptions sequence_of(const ReconstructChoices& choices,
                            const ReconstructionOptions& reconstruction, Run& run);

/// Returns the paths of the inputs of one time step.
ViewSources sources_of(const ViewSources& sources, const TimeStep& step);

/// Reads the views. If masks are exact, checks whether the silhouettes of the views agree.
std::vector<View> checked_views(const ViewSources& sources, const ReconstructChoices& choices,
                                Run& run);

/// If requested, colors the result from the photographs of the views that were used.
void color_result(const ReconstructChoices& choices, const std::set<std::string>& views, Run& run);

}  // namespace transformesh::tool
