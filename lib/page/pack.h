/// Meshes packed for a browser: 16 bits per coordinate and per column value, compressed. The error
/// of a coordinate is at most half of 1/65535 of the box's extent along its axis.
///
/// An uncompressed block starts with four bytes, the size of the JSON that follows. The JSON has
/// `vertices`, `faces`, `low` and `high` of the box, and `columns` (`name`, `of`: vertex, face or
/// color, and `low` and `high` of numbers). Then come streams of little-endian integers. Each
/// stream is stored in planes: first the lowest byte of every integer, then the next byte.
/// - Corners of faces, in order. Vertices are numbered in the order in which faces use them, unused
///   vertices last. A corner is stored as the next unused number minus the vertex number,
///   or 0 for a new vertex. Integers have four bytes, or two if there are at most 65535 vertices.
/// - x, then y, then z of all vertices: integers 0 to 65535 from `low` to `high`, each as the
///   difference from the previous one, modulo 65536.
/// - Columns: integers 0 to 65534 from `low` to `high`, as differences like the coordinates.
///   65535 is a non-finite number. A color is three streams of bytes, red, green and blue, as
///   differences modulo 256.
///
/// Lists, normals and velocities (nx ny nz, vx vy vz) are left out. Faces keep their order. Cost:
/// linear except for the compression. Deterministic for a given version of zlib.
#pragma once

#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct PackedColumn {
  enum class Of { vertex, face, color } of = Of::vertex;
  std::string name;
  double low = 0, high = 0;  ///< range of the finite values; 0 if there are none
};

struct PackedMesh {
  std::size_t vertices = 0, faces = 0;
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  double radius = 0;  ///< radius of the ball around the box's center that contains all vertices
  std::vector<PackedColumn> columns;
  std::string block;
};

PackedMesh pack(const Mesh& mesh);

}  // namespace transformesh
