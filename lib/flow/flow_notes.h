/// Sentences for messages about vertices and times outside of the grids of a flow.
#pragma once

#include <string>
#include <vector>

#include "support/counted.h"
#include "transformesh/flow.h"

namespace transformesh {

inline std::vector<std::string> notes_of(const FlowCounts& counts) {
  std::vector<std::string> notes;
  if (counts.outside > 0)
    notes.push_back(counted(counts.outside, "vertex") +
                    " outside of the grid took the value at the nearest point of the grid");
  if (counts.is_time_outside)
    notes.emplace_back(
        "for times before the first grid or after the last one, the values of that grid are used");
  return notes;
}

}  // namespace transformesh
