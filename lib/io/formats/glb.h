/// glTF 2.0 (ISO/IEC 12113:2022) in the axes of the mesh: read as binary (GLB) and as text, written
/// as GLB.
///
/// Writes one primitive of triangles, or of points if there are no faces. Coordinates are floats.
/// All numeric vertex columns in the range of float are kept. `nx ny nz` become NORMAL, of unit
/// length. `red green blue (alpha)` become COLOR_0, as bytes or floats from 0 to 1. `s t` (or `u
/// v`, `texture_u texture_v`) become TEXCOORD_0, whose v runs downwards. Any other column becomes
/// the float attribute `_NAME`. If the face column `texcoord` (obj.h) exists, it is TEXCOORD_0
/// instead. A vertex with several texture coordinates is then repeated after the other vertices.
/// Document::texture is the base color, shown unlit (KHR_materials_unlit), because photographs
/// already contain the lighting. For a closed, oriented manifold, EXT_mesh_manifold (E. Lalish,
/// Khronos glTF extensions, 2024) records this property and which repeated vertices are one.
/// Comments are in the extras of `asset`.
///
/// Reading joins all meshes of the scene, transformed by their nodes; gltf_mesh.h lists the
/// attributes that are read. Colors of vertices and materials are taken unchanged, without a
/// conversion between linear and sRGB.
#pragma once

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// Reads glTF as read_mesh() does. External buffers are read from `folder`. If `folder` is empty,
/// files with external buffers are rejected.
ReadResult read_glb(const Source& source, const std::string& folder);

/// Writes GLB as write_mesh() does. Throws GoalError if the file would exceed 4 GB, the limit of
/// its header.
WriteResult write_glb(const Document& document);

}  // namespace transformesh
