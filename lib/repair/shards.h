/// Finds shards: components that are too small to be parts of a model, such as remains of cut
/// faces. O(n).
#pragma once

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the area below which a component is a shard; 0 if the mesh has no shards.
double least_area(const Mesh& mesh);

}  // namespace transformesh
