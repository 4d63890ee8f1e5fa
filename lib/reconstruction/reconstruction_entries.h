/// Report entries of reconstructions and of the check of views (entries.h).
#pragma once

#include "entries/entries.h"
#include "reconstruction/sequence.h"
#include "transformesh/reconstruct.h"
#include "views/hull/view_check.h"

namespace transformesh {

/// Doubtful places are one text: the largest places, separated by semicolons.
Entries entries_of(const ReconstructionResult& result);
Entries entries_of(const SequenceResult& result);

/// Entries of a check after which `views` views are left.
Entries entries_of(const ViewCheck& check, std::size_t views);

}  // namespace transformesh
