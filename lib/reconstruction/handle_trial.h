/// Removes handles and tunnels without which photographs agree better. The visual hull and depth
/// maps have false tunnels. Windows of photographs are hardly smaller than a narrow tunnel, so that
/// its walls are not doubtful enough for carving (carving.h) or for a fault (surface_doubt.h).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "transformesh/document.h"
#include "views/photo/disagreement.h"

namespace transformesh {

struct HandleTrialStages {
  std::function<std::vector<WindowSums>(const Mesh&)> measure;  ///< Disagreement::of_vertex
  std::function<void(Document&)> settle;  ///< cleans the mesh, then takes the steps of a sweep
};

/// Removes all handles with a loop of at most `max_length` from a copy (handles.h), fills pits that
/// remain of tunnels, and calls `settle`. Compares the disagreement of photographs near the removed
/// loops with that on the document. The copy replaces the document if the disagreement is clearly
/// less (is_clearly_less()) and the compared windows weigh no less. A thin part of the object that
/// was cut has fewer windows. Returns the number of removed handles, 0 if the document was not
/// replaced, or nothing if no handle has such a loop. Precondition: the mesh is a closed oriented
/// manifold.
std::optional<std::size_t> try_without_handles(Document& document, double max_length,
                                               const HandleTrialStages& stages);

}  // namespace transformesh
