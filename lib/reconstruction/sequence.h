/// Reconstructs a movie (paper 5.3.3), one time step after the other. Each time step begins with
/// the previous surface. The result is compared with the last surface that was not tracked. If it
/// is worse (tracking_faults), the surface is also reconstructed from its visual hull, and the
/// better of both is used.
///
/// Each time step is an iteration of the loop: it is recorded, resumed and limited like one.
/// Reconstructions within a time step have states of their own. Throws what reconstruct() throws,
/// with the number of the time step. Deterministic.
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
  /// `initial` and the coarsest scale apply to surfaces that do not begin with the previous one.
  ReconstructionOptions reconstruction;
  double track = 4;  ///< coarsest scale of surfaces that begin with the previous one
  std::vector<std::string> comments = {};  ///< comments of surfaces that begin with a hull
  std::string folder;                  ///< folder for surfaces NAME.ply or NAME.off; empty: none
  Format format = Format::ply_little;  ///< format of the surfaces
  /// Folder for states within a time step, in that of the record; empty: none.
  std::string states = {};
  std::function<void(const std::string& message)> on_step = {};
  std::function<void(const std::string& message)> on_note = {};
};

struct SequenceResult {
  std::size_t time_steps = 0;  ///< number of finished time steps, with those of earlier runs
  std::size_t tracked = 0;     ///< number of time steps that use the previous surface
  std::size_t accepted = 0;    ///< number of time steps without tracking faults
};

/// Reconstructs all time steps. `views_of` returns the views of a time step; it is called once per
/// step, in order. On input, the document is the given initial mesh, if any. On output, it is the
/// last surface.
SequenceResult reconstruct_sequence(
    Document& document, const std::vector<TimeStep>& time_steps,
    const std::function<std::vector<View>(const TimeStep& time_step)>& views_of,
    const SequenceOptions& options, Record& record, const Progress& progress = Progress());

}  // namespace transformesh
