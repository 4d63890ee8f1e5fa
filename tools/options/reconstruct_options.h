/// The options of tm-reconstruct, and what they mean to the library.
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

/// Options as they are written; the rest are in `options`.
struct ReconstructChoices {
  ViewSources sources;
  ReconstructionOptions options;
  std::string silhouettes_show = "exact";
  std::string threshold;
  std::string keep = "largest";
  std::string clip = "hull";
  std::string hollows = "auto";
  std::string sequence;
  double track = SequenceOptions().track;
  std::string coarsest = "auto";
  std::string last_edge;
  std::string iterations = "auto";
  std::vector<double> box;
  std::string window = "3";
  std::string pull = "auto";
  ViewCheckChoices check;
  bool is_colored = false;
  ColorChoices color;
  LoopChoices loop;
};

void declare_reconstruction(Program& program, ReconstructChoices& choices);

/// Throws UsageError for values that are none and for options that do not go together.
ReconstructionOptions reconstruction_of(const ReconstructChoices& choices, Run& run);

/// All but the comments. Throws UsageError where places do not name the time step.
SequenceOptions sequence_of(const ReconstructChoices& choices,
                            const ReconstructionOptions& reconstruction, Run& run);

/// The places of one time step.
ViewSources sources_of(const ViewSources& sources, const TimeStep& step);

/// The views, of which those with masks that show the object exactly are checked.
std::vector<View> checked_views(const ViewSources& sources, const ReconstructChoices& choices,
                                Run& run);

/// Colors the result where that was asked for, by the photographs of the views that were used.
void color_result(const ReconstructChoices& choices, const std::set<std::string>& views, Run& run);

}  // namespace transformesh::tool
