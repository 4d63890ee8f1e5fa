/// Chooses the components of a visual hull that belong to the object.
///
/// A hull has phantoms: components where silhouettes of several parts of the object happen to
/// overlap. The object fills its silhouettes without phantoms. So a component is needed only if
/// some of its pixels in the views are not covered by larger needed components.
#pragma once

#include <cstddef>
#include <span>

#include "transformesh/mesh.h"
#include "views/cameras/view.h"

namespace transformesh {

/// Keeps the largest component by volume. Keeps each further component if larger needed components
/// leave more than a tenth of its pixels uncovered, over all views. Drops all other components,
/// components of less than a thousandth of the largest volume, and cavities. Components are drawn
/// in images of at most 320 pixels. A component that other parts of the object hide in almost every
/// view is dropped. Returns the number of dropped components. Parallel; the result does not depend
/// on the number of threads.
std::size_t drop_unneeded_components(Mesh& mesh, std::span<const View> views);

}  // namespace transformesh
