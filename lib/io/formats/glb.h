/// glTF 2.0 (ISO/IEC 12113:2022) in the axes of the mesh: read as binary (GLB) and as text, written
/// as GLB. One primitive is written, of triangles, or of points if there are no faces. Coordinates
/// are floats. Kept are all vertex columns that are numbers a float can hold: `nx ny nz` as NORMAL,
/// of unit length, `red green blue (alpha)` as COLOR_0, bytes or floats from 0 to 1, `s t` (or `u
/// v`, `texture_u texture_v`) as TEXCOORD_0, whose v runs downwards; any other as the attribute
/// `_NAME` of floats. The face column `texcoord` (obj.h) is TEXCOORD_0 instead: a vertex whose
/// corners have several places in the texture is repeated behind the others. Document::texture is
/// the base color, shown as it is, since photographs have their light in them
/// (KHR_materials_unlit). If the mesh is closed, oriented and manifold, EXT_mesh_manifold (E.
/// Lalish, Khronos glTF extensions, 2024) says so and which repeated vertices are one. Comments are
/// in the extras of `asset`.
///
/// Reading joins all meshes of the scene, moved by their nodes: see gltf_mesh.h for what of a mesh
/// is read. Colors of vertices and materials are taken as the numbers that they are, without a
/// conversion between linear and sRGB.
#pragma once

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// See read_mesh. Buffers in files of their own are read from `folder`; an empty name refuses them.
ReadResult read_glb(const Source& source, const std::string& folder);

/// Throws GoalError where the file would be longer than the 4 GB that its header can state.
WriteResult write_glb(const Document& document);

}  // namespace transformesh
