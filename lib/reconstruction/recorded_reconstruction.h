/// Runs a reconstruction (reconstruct.h) and stores its states in a record (record.h) that the
/// caller has opened. A run can be resumed from its record.
#pragma once

#include <string>
#include <vector>

#include "evolution/loop/record.h"
#include "transformesh/reconstruct.h"
#include "views/cameras/view.h"

namespace transformesh {

/// Reconstructs like reconstruct() in reconstruct.h. In addition, stores the initial mesh as
/// `start.ply` in the record's folder, and the hull of thresholded silhouettes, if there is one, as
/// `hull.ply`.
ReconstructionResult reconstruct(Document& document, std::vector<View>& views,
                                 const ReconstructionOptions& options, Record& record,
                                 const Progress& progress = Progress());

/// Returns a summary such as "2 sweeps: 812 faces, components 1, genus 0; ...".
std::string summary_of(const ReconstructionResult& result);

}  // namespace transformesh
