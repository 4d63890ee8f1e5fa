/// Meshes packed to be looked at in a browser: 16 bits per coordinate and per number, deflated. The
/// error of a coordinate is at most half of 1/65535 of the box's extent along its axis.
///
/// Before it is deflated a block is: four bytes, the size of what follows; JSON with `vertices`,
/// `faces`, `low` and `high` of the box, and `columns` (`name`, `of`: vertex, face or color, and of
/// numbers `low` and `high`); then streams of numbers, all of least significant bytes first, each
/// stream in planes: first the lowest byte of every number, then the next.
///   - Corners of faces, in order: how far the vertex lies below the next new one; 0 is the new one
///     itself. Of four bytes, or two where there are at most 65535 vertices. Vertices come in the
///     order in which faces use them, then those that no face does.
///   - x, then y, then z of all vertices: integers 0 to 65535 from `low` to `high`, each as its
///     difference from the one before, modulo 65536.
///   - Columns likewise, of integers 0 to 65534; 65535 is a number that is not finite. A color is
///     three streams of bytes, red, green and blue.
///
/// Lists are left out, and so are normals and velocities (nx ny nz, vx vy vz). Faces keep their
/// order. Cost: linear but for deflating. Deterministic for a version of zlib.
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace transformesh {

struct PackedColumn {
  enum class Of { vertex, face, color } of = Of::vertex;
  std::string name;
  double low = 0, high = 0;  ///< of the finite values; 0 where there is none
};

struct PackedMesh {
  std::size_t vertices = 0, faces = 0;
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  double radius = 0;  ///< of the ball around the box's middle that holds all vertices
  std::vector<PackedColumn> columns;
  std::string block;
};

PackedMesh pack(const Mesh& mesh);

}  // namespace transformesh
