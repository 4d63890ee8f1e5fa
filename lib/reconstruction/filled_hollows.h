/// Finds smooth parts of a surface that fill hollows of the object, such as films across holes.
///
/// A camera that observes a film at a grazing angle shows the wall of the hole instead, a few
/// pixels high. Windows of 3x3 pixels disagree there, but hardly more than at creases, which the
/// edges of the mesh round off. A trial decides: on a surface that is six pixels deeper at the
/// film, photographs agree clearly better. The depth of the hole, and whether it is a tunnel, may
/// be visible in no photograph.
#pragma once

#include <functional>
#include <vector>

#include "transformesh/mesh.h"
#include "views/photo/disagreement.h"

namespace transformesh {

/// Returns the vertices of each filled hollow. It is a connected set of vertices of at least 50
/// squared pixels with WindowSums::excess above 0.4. Normals of the set and of its neighbors are
/// within 37 degrees of their mean. Moving all these sets inwards by six pixels reduces the excess
/// of the set and its neighbors clearly (is_clearly_less()), and does not reduce the weight of
/// windows that agree. `measure` returns Disagreement::of_vertex of a mesh by windows of 3x3
/// pixels, and `sums` is its result on `mesh`. `pixel` is the size of a pixel at the object, in
/// input units. Calls `measure` at most once.
std::vector<std::vector<Index>> filled_hollows(
    const Mesh& mesh, const std::vector<WindowSums>& sums, double pixel,
    const std::function<std::vector<WindowSums>(const Mesh&)>& measure);

}  // namespace transformesh
