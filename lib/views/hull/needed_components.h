/// Chooses the components of a visual hull that belong to the object.
///
/// A hull has phantoms: components where silhouettes of several parts of the object happen to
/// overlap. The object fills its silhouettes without them. So a component is needed only if its
/// outline shows something that the outlines of larger needed components do not cover.
#pragma once

#include <cstddef>
#include <span>

#include "transformesh/mesh.h"
#include "views/cameras/view.h"

namespace transformesh {

/// Keeps the largest component by volume, and each further one of whose outlines larger needed
/// components leave more than a tenth uncovered, summed over the views. Drops all others, those of
/// less than a thousandth of the largest volume, and cavities. Outlines are drawn in images of at
/// most 320 pixels. A component that other parts of the object hide in almost every view is
/// dropped. Returns the number of dropped components. Parallel; the result does not depend on the
/// number of threads.
std::size_t drop_unneeded_components(Mesh& mesh, std::span<const View> views);

}  // namespace transformesh
