/// One mesh of a glTF file, all of its primitives together.
#pragma once

#include <string>
#include <vector>

#include "io/formats/gltf_file.h"
#include "io/streams/expand.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Counts of what a mesh cannot hold.
struct GltfLosses {
  std::size_t line_primitives = 0;
  std::size_t unread_attributes = 0;
  std::size_t unused_merges = 0;  ///< meshes whose EXT_mesh_manifold does not fit their primitives
};

/// Returns the triangles of a mesh, or its points. NORMAL becomes nx ny nz, COLOR_0 red green blue
/// alpha of vertices, TEXCOORD_0 s t, and an attribute _NAME of scalars a column. The base colors
/// of materials become those of faces. Vertices that EXT_mesh_manifold merges are one; their
/// texture coordinates become the face column `texcoord`. Throws InputError.
Mesh gltf_mesh(const GltfFile& file, std::size_t mesh, ExpansionBudget& budget, GltfLosses& losses);

}  // namespace transformesh
