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
                    " outside of the grid took the value of its nearest point");
  if (counts.is_time_outside)
    notes.emplace_back(
        "a time before the first grid, or after the last one, took the values of that grid");
  return notes;
}

}  // namespace transformesh
