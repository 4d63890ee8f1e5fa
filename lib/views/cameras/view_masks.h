/// Reads the masks of views.
#pragma once

#include <string>
#include <vector>

#include "transformesh/views.h"
#include "views/cameras/view.h"

namespace transformesh {

/// Reads a mask into the silhouette of each view. A mask that is smaller or larger than its
/// photograph, with the same aspect ratio, is scaled. `sources.on_note` is told how masks were
/// read. Throws InputError, naming the file, if a mask has another aspect ratio or no pixel inside.
/// Parallel; deterministic.
void decode_masks(const std::vector<std::string>& paths, const ViewSources& sources,
                  std::vector<View>& views);

}  // namespace transformesh
