/// Which faces of a mesh to keep: masks for select_faces() of components.h, which drops vertices
/// that no face uses, and keeps order and columns. Open meshes and soups do. Components hang
/// together by vertex indices. Deterministic. Cost: O(n log n).
/// (component_around.h of geometry: the one around a point.)
#pragma once

#include <string>
#include <vector>

#include "transformesh/components.h"
#include "transformesh/measure.h"

namespace transformesh {

/// The faces of the `count` largest components; of equal ones the first.
std::vector<bool> faces_of_largest(const Mesh& mesh, std::size_t count, ComponentSize by);
/// The faces of components that are at least so large.
std::vector<bool> faces_of_at_least(const Mesh& mesh, double size, ComponentSize by);

/// `COLUMN OP NUMBER`, with OP of < <= = != >= >: faces for which it holds by a face column, else
/// at all three corners by a vertex column. Throws UsageError for other text, InputError where
/// there is no such column of numbers.
std::vector<bool> faces_where(const Mesh& mesh, const std::string& condition);

/// Faces with all corners in the box, its sides included.
std::vector<bool> faces_in_box(const Mesh& mesh, const Box& box);

}  // namespace transformesh
