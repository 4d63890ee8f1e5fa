/// Messages about meshes with more elements than 32-bit indices can number.
#pragma once

namespace transformesh {

/// A mesh has fewer than `no_index` vertices (mesh.h).
inline constexpr const char* too_many_vertices =
    "more than 4294967294 vertices are not supported: split the input into smaller files";
/// A mesh has fewer than `no_index / 3` faces, so that indices of halfedges are below `no_index`.
inline constexpr const char* too_many_triangles =
    "more than 1431655764 triangles are not supported: split the input into smaller files";

}  // namespace transformesh
