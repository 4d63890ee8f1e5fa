/// Chooses the components of a visual hull that belong to the object.
///
/// A visual hull may have phantoms: components that are no part of the object, at places where
/// silhouettes of different parts of the object happen to overlap. The object covers its
/// silhouettes without phantoms. A component is therefore needed only if it covers pixels of the
/// views that larger needed components do not cover.
#pragma once

#include <cstddef>
#include <span>

#include "transformesh/mesh.h"
#include "views/cameras/view.h"

namespace transformesh {

/// Keeps the largest component by volume. Keeps each further component if more than a tenth of its
/// pixels, over all views, are not covered by larger needed components. Drops all other components,
/// components of less than a thousandth of the largest volume, and cavities. Components are
/// compared in images of at most 320 pixels. A true part of the object is dropped, too, if larger
/// components cover its pixels in almost every view. Returns the number of dropped components.
/// Parallel; the result does not depend on the number of threads.
std::size_t drop_unneeded_components(Mesh& mesh, std::span<const View> views);

}  // namespace transformesh
