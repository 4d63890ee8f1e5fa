/// Submeshes of a large mesh in or near a box. Deterministic. Cost: O(n) time, a few bits of memory
/// per face.
#pragma once

#include <vector>

#include "mesh/triangle.h"
#include "transformesh/measure.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Returns 1 for each face whose first vertex is in the half-open box.
std::vector<bool> faces_of_box(const Mesh& mesh, const Box& box);

/// Returns the bounding box of the marked faces; an inverted box if there are none.
Box box_around(const Mesh& mesh, const std::vector<bool>& faces);

/// Returns the bounding box of the first vertices of the marked faces.
Box first_vertices(const Mesh& mesh, const std::vector<bool>& faces);

/// Returns 64 times the spacing of floating-point numbers at the largest coordinate in the box.
/// Rounding moves vertices by less.
double margin_around(const Box& box, Scalar coordinate);
Box with_margin(const Box& box, Scalar coordinate);

/// Returns 1 for each face whose bounding box touches the box.
std::vector<bool> faces_near(const Mesh& mesh, const Box& box);

/// Some faces of a mesh as a separate mesh.
struct BoxSubmesh {
  Mesh mesh;
  std::vector<Index> face_of;  ///< index of each face in the whole mesh
};

/// Returns the marked faces as a mesh. Its vertices are the corners of the marked faces, and all
/// other vertices at the same positions. Hence the first vertex at each position is the same as in
/// the whole mesh. The order of vertices and faces, and their columns, do not change.
BoxSubmesh take_submesh(const Mesh& mesh, const std::vector<bool>& faces);

/// Two hashes of a mesh, computed face by face from the positions of the corners: one tells whether
/// the mesh is closed, the other identifies the mesh. The probability that two different meshes
/// have equal hashes, or that an open mesh passes as closed, is 2^-64.
class FaceSums {
 public:
  void add(const Triangle& triangle);
  /// True if each edge is traversed equally often in both directions. Faces without area are
  /// ignored.
  bool is_closed() const { return edges_ == 0; }
  /// Returns a hash that depends on the faces and their order.
  std::uint64_t hash() const { return faces_; }

 private:
  std::uint64_t edges_ = 0, faces_ = 0;
};

FaceSums face_sums(const Mesh& mesh);

}  // namespace transformesh
