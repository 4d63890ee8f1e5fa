/// Facts about a mesh, computed without the library: by exact predicates of CGAL on the coordinates
/// as written, and by counting edges.
#pragma once

#include <cstddef>
#include <string>

#include "corpus/chains/triangle_mesh.h"

namespace chains {

struct MeshFacts {
  std::size_t faces = 0;
  std::size_t bad_indices = 0;      ///< faces with an index out of range or a repeated index
  std::size_t bad_coordinates = 0;  ///< points that are not finite
  std::size_t open_edges = 0;       ///< edges with one face, compared by vertex index
  /// Directed edges, compared by position, without a matching edge in the opposite direction. 0 for
  /// a closed soup.
  std::size_t unpaired_places = 0;
  std::size_t bad_edges = 0;     ///< edges that two faces traverse in the same direction
  std::size_t bad_vertices = 0;  ///< vertices whose faces do not form one umbrella
  std::size_t no_area = 0;       ///< faces whose corners are exactly collinear
  /// Pairs of faces that intersect outside of corners and edges at equal coordinates, as defined in
  /// tm-checkmanifold(1). A pair with three equal corners counts; faces without area do not.
  std::size_t intersections = 0;
  std::size_t components = 0;  ///< components; faces that share a vertex by index are connected
  double area = 0;
  double volume = 0;

  bool is_valid() const { return bad_indices + bad_coordinates == 0; }
  bool is_closed() const { return open_edges == 0; }
  bool is_manifold() const { return bad_edges + bad_vertices == 0; }
  /// Returns true if the mesh has no fault that a later program could inherit from its input.
  bool is_sound() const { return is_valid() && is_manifold() && no_area + intersections == 0; }
};

MeshFacts judge(const TriangleMesh& mesh);

}  // namespace chains
