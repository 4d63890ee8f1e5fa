/// Submeshes of a large mesh that lie in or near a box. Deterministic. Cost: O(n), a few bits a
/// face.
#pragma once

#include <vector>

#include "mesh/triangle.h"
#include "transformesh/measure.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// The faces whose first vertex is in the half-open box.
std::vector<bool> faces_of_box(const Mesh& mesh, const Box& box);

/// The box around faces; nothing is in it where there are none.
Box box_around(const Mesh& mesh, const std::vector<bool>& faces);

/// The box around the first vertices of faces.
Box first_vertices(const Mesh& mesh, const std::vector<bool>& faces);

/// 64 spacings of coordinates in the box: rounding moves vertices by fewer.
double margin_around(const Box& box, Scalar coordinate);
Box with_margin(const Box& box, Scalar coordinate);

/// The faces whose own boxes touch the box.
std::vector<bool> faces_near(const Mesh& mesh, const Box& box);

/// Some faces of a mesh as a mesh of their own.
struct BoxSubmesh {
  Mesh mesh;
  std::vector<Index> face_of;  ///< index of each face in the whole mesh
};

/// Vertices that are in the place of a used one come along, used or not: so the first vertex of
/// every place is the same as in the mesh. Order and columns stay.
BoxSubmesh take_submesh(const Mesh& mesh, const std::vector<bool>& faces);

/// Sums of hashes of the faces of a mesh, by positions, which come one by one. A different mesh has
/// the same sums, or an open one passes as closed, by a chance of 2^-64.
class FaceSums {
 public:
  void add(const Triangle& triangle);
  /// Whether every edge is traversed equally often in both directions; faces without area do not
  /// count.
  bool is_closed() const { return edges_ == 0; }
  /// Depends on the faces and their order.
  std::uint64_t hash() const { return faces_; }

 private:
  std::uint64_t edges_ = 0, faces_ = 0;
};

FaceSums face_sums(const Mesh& mesh);

}  // namespace transformesh
