/// The loop of reconstruct.h with a record that the caller has opened.
#pragma once

#include <string>
#include <vector>

#include "evolution/loop/record.h"
#include "transformesh/reconstruct.h"
#include "views/cameras/view.h"

namespace transformesh {

/// In the record's folder `start.ply` and `hull.ply` are kept as well.
ReconstructionResult reconstruct(Document& document, std::vector<View>& views,
                                 const ReconstructionOptions& options, Record& record,
                                 const Progress& progress = Progress());

/// Returns "2 sweeps: 812 faces, components 1, genus 0; ...".
std::string summary_of(const ReconstructionResult& result);

}  // namespace transformesh
