/// Reads the masks of views.
#pragma once

#include <string>
#include <vector>

#include "transformesh/views.h"
#include "views/cameras/view.h"

namespace transformesh {

/// Reads the mask at `paths[i]` into the silhouette of `views[i]`. A mask of another size than its
/// photograph is scaled if it has the same aspect ratio. Calls `sources.on_note` with messages on
/// how masks were interpreted. Throws InputError, naming the file, if a mask has another aspect
/// ratio or no pixel inside. Parallel; deterministic.
void decode_masks(const std::vector<std::string>& paths, const ViewSources& sources,
                  std::vector<View>& views);

}  // namespace transformesh
