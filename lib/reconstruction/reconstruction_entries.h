/// Makes the entries (names and values, entries.h) of JSON and text reports on reconstructions and
/// on checks of views.
#pragma once

#include "entries/entries.h"
#include "reconstruction/sequence.h"
#include "transformesh/reconstruct.h"
#include "views/hull/view_check.h"

namespace transformesh {

/// The entry `doubtful_places` is a text: up to ten places, the largest first, separated by
/// semicolons.
Entries entries_of(const ReconstructionResult& result);
Entries entries_of(const SequenceResult& result);

/// Returns the entries of a check of views; `views` is the number of views that are left after it.
Entries entries_of(const ViewCheck& check, std::size_t views);

}  // namespace transformesh
