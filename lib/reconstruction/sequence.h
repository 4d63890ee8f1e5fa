/// Reconstruction of a movie (paper 5.3.3): time steps one after the other, each from the surface
/// before. It is made anew from its visual hull where the result is not as good as the last surface
/// that was not tracked, and the better of both is taken (tracking_faults).
///
/// Each time step is an iteration of the loop: recorded, resumed and limited as such, and the runs
/// within it have states of their own. Throws what reconstruct() throws, with the number of the
/// time step. Deterministic.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "evolution/loop/record.h"
#include "reconstruction/time_steps.h"
#include "transformesh/reconstruct.h"
#include "views/cameras/view.h"

namespace transformesh {

struct SequenceOptions {
  /// `start` and the coarsest scale are those of surfaces that do not begin with the one before.
  ReconstructionOptions reconstruction;
  double track = 4;                        ///< the coarsest scale of those that do
  std::vector<std::string> comments = {};  ///< of surfaces that begin with a hull
  std::string folder;                      ///< for the surfaces, NAME.ply or NAME.off, or none
  Format format = Format::ply_little;      ///< of these
  std::string states = {};  ///< folder, the record's, for states within a time step; empty: none
  std::function<void(const std::string& message)> on_step = {};
  std::function<void(const std::string& message)> on_note = {};
};

struct SequenceResult {
  std::size_t time_steps = 0;  ///< that are done, those of earlier runs included
  std::size_t tracked = 0;     ///< of these, with the surface before
  std::size_t accepted = 0;    ///< as good as from a hull
};

/// `views_of` is asked for the views of each time step in turn. The document is the first start
/// where one is given, and the last surface afterwards.
SequenceResult reconstruct_sequence(
    Document& document, const std::vector<TimeStep>& time_steps,
    const std::function<std::vector<View>(const TimeStep& time_step)>& views_of,
    const SequenceOptions& options, Record& record, const Progress& progress = Progress());

}  // namespace transformesh
