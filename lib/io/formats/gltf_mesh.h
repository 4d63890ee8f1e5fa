/// One mesh of a glTF file, with all of its primitives.
#pragma once

#include <string>
#include <vector>

#include "io/formats/gltf_file.h"
#include "io/streams/expand.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Numbers of items of a glTF file that are left out, because a mesh cannot represent them.
struct GltfLosses {
  std::size_t line_primitives = 0;
  std::size_t unread_attributes = 0;
  /// Number of meshes whose EXT_mesh_manifold does not fit their primitives.
  std::size_t unused_merges = 0;
};

/// Returns the triangles of a glTF mesh, or its points. NORMAL becomes the columns nx ny nz.
/// COLOR_0 becomes red green blue alpha of vertices, TEXCOORD_0 becomes s t, and a scalar attribute
/// _NAME becomes the column `name`. Base colors of materials become face colors. Vertices that
/// EXT_mesh_manifold merges are one vertex, and their texture coordinates become the face column
/// `texcoord`. Throws InputError.
Mesh gltf_mesh(const GltfFile& file, std::size_t mesh, ExpansionBudget& budget, GltfLosses& losses);

}  // namespace transformesh
