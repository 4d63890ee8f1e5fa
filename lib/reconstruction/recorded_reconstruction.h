/// The loop of reconstruct.h, whose states are stored in a record (record.h) that the caller has
/// opened.
#pragma once

#include <string>
#include <vector>

#include "evolution/loop/record.h"
#include "transformesh/reconstruct.h"
#include "views/cameras/view.h"

namespace transformesh {

/// Reconstructs as described in reconstruct.h. Also stores the initial mesh as `start.ply` and the
/// hull of thresholded silhouettes, if any, as `hull.ply` in the record's folder.
ReconstructionResult reconstruct(Document& document, std::vector<View>& views,
                                 const ReconstructionOptions& options, Record& record,
                                 const Progress& progress = Progress());

/// Returns a summary such as "2 sweeps: 812 faces, components 1, genus 0; ...".
std::string summary_of(const ReconstructionResult& result);

}  // namespace transformesh
