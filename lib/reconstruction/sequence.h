/// Reconstructs a movie of a moving object (paper 5.3.3), one time step after the other. The
/// initial mesh of each time step is the surface of the previous one. The result is called tracked.
/// A tracked surface is compared with the last surface that was not tracked. If it is worse
/// (tracking_faults()), the time step is also reconstructed from its visual hull, and the better
/// surface is used.
///
/// Each time step is an iteration of a Loop (evolution/loop), after which the run can be resumed.
/// The reconstruction of a time step has a recorded state of its own. Throws what reconstruct()
/// throws, with the number of the time step. Deterministic.
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
  /// The members `initial` and `scales.coarsest` apply only to surfaces that are not reconstructed
  /// from the surface of the previous time step.
  ReconstructionOptions reconstruction;
  double track = 4;  ///< coarsest scale if a time step starts from the previous surface
  /// Comments for the file headers of surfaces that are reconstructed from a visual hull.
  std::vector<std::string> comments = {};
  /// Folder in which the surface of each time step is stored as NAME.ply or NAME.off; empty: none.
  std::string folder;
  Format format = Format::ply_little;  ///< file format of these surfaces
  /// Folder for the state of an unfinished time step, from which a run resumes; empty: none.
  std::string states = {};
  std::function<void(const std::string& message)> on_step = {};
  std::function<void(const std::string& message)> on_note = {};
};

struct SequenceResult {
  /// Number of finished time steps, including those before a run was resumed.
  std::size_t time_steps = 0;
  std::size_t tracked = 0;  ///< time steps reconstructed from the previous surface
  /// Number of time steps whose surface has no tracking_faults(), or is not reconstructed from the
  /// surface of the previous time step.
  std::size_t accepted = 0;
};

/// Reconstructs all time steps. `views_of` returns the views of a time step; it is called once per
/// step, in order. On input, the document is the given initial mesh, if any. On output, it is the
/// last surface.
SequenceResult reconstruct_sequence(
    Document& document, const std::vector<TimeStep>& time_steps,
    const std::function<std::vector<View>(const TimeStep& time_step)>& views_of,
    const SequenceOptions& options, Record& record, const Progress& progress = Progress());

}  // namespace transformesh
