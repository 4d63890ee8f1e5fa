/// Entries of reports about reconstructions and the check of views (entries.h).
#pragma once

#include "entries/entries.h"
#include "reconstruction/sequence.h"
#include "transformesh/reconstruct.h"
#include "views/hull/view_check.h"

namespace transformesh {

/// The doubtful places are one text: the largest ones, joined by semicolons.
Entries entries_of(const ReconstructionResult& result);
Entries entries_of(const SequenceResult& result);

/// For a check that left `views` views.
Entries entries_of(const ViewCheck& check, std::size_t views);

}  // namespace transformesh
