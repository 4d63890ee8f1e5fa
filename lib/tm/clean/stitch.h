/// Stitching a soup of triangles into a mesh (paper 3.3): equal positions become one vertex, and
/// then every vertex at which the faces form more than one umbrella is duplicated, so that singular
/// vertices, edges and triangles come apart and the result is a manifold wherever the faces allow
/// it. At a singular edge sheets pair across the inside, behind both faces, in exact angular order.
/// References: the paper, 3.3; Gueziec, Taubin, Lazarus & Horn, "Cutting and stitching", TVCG 2001.
///
/// The first vertex of each position survives, with its columns; faces keep their order. Faces that
/// name a position twice are dropped. Two faces that run the same way along an edge stay apart
/// there unless `orient`. Throws InputError where a component cannot be oriented (a Moebius strip),
/// naming a face. Cost: O(n log n). Deterministic.
#pragma once

#include "tm/mesh/mesh.h"

namespace transformesh {

struct StitchOptions {
  double tolerance = 0;  ///< join positions within this distance, input units; 0: equal ones
  bool orient = false;   ///< turn faces so that neighbours agree; components that needed it and are
                         ///< closed then look outwards, others look the way most faces did
  bool flip = false;     ///< reverse all faces, at the end
};

struct StitchResult {
  std::size_t joined_vertices = 0;  ///< how many positions were given more than once
  std::size_t copied_vertices = 0;  ///< duplicates made at singular vertices, edges, triangles
  std::size_t dropped_faces = 0;
  std::size_t turned_faces = 0;       ///< by `orient`
  std::size_t misoriented_edges = 0;  ///< left between two faces that run the same way
  std::size_t border_edges = 0;       ///< left without a partner
};

StitchResult stitch(Mesh& mesh, const StitchOptions& options = {});

}  // namespace transformesh
