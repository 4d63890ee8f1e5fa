/// Conditions on faces. The functions return masks for select_faces() of components.h, which drops
/// unused vertices and keeps order and columns. The mesh may be open or a soup. Components are
/// connected by vertex indices. component_around.h in geometry selects the component around a
/// point. Deterministic. Cost: O(n log n).
#pragma once

#include <string>
#include <vector>

#include "transformesh/components.h"
#include "transformesh/measure.h"

namespace transformesh {

/// Selects the faces of the `count` largest components; ties are decided by the order of
/// components.
std::vector<bool> faces_of_largest(const Mesh& mesh, std::size_t count, ComponentSize by);
/// Selects the faces of components of at least this size.
std::vector<bool> faces_of_at_least(const Mesh& mesh, double size, ComponentSize by);

/// Parses `COLUMN OP NUMBER`, where OP is one of < <= = != >= >. Selects the faces for which the
/// condition holds: for a face column at the face, otherwise for a vertex column at all three
/// corners. Throws UsageError for other text, and InputError if there is no numeric column of this
/// name.
std::vector<bool> faces_where(const Mesh& mesh, const std::string& condition);

/// Selects the faces with all corners in the closed box.
std::vector<bool> faces_in_box(const Mesh& mesh, const Box& box);

}  // namespace transformesh
