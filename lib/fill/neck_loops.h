/// Finds short loops of edges around necks. A neck is a place at which a surface is narrower than
/// on either side of it. Loops around thin handles are found, too. Loops around thin protrusions
/// and bumps are not.
///
/// Shortest paths are grown from every vertex, up to half the largest length of a loop. If the
/// reached vertices lie around a neck, the faces between them form a ring instead of a disk. Then
/// some edge is neither in the tree of shortest paths, nor crossed by a spanning tree of the faces.
/// This edge and the paths to its ends form a loop. Reference: Erickson and Whittlesey, Greedy
/// optimal homotopy and homology generators, SODA 2005.
///
/// A loop is around a neck if the surface widens on both sides of the loop. The surface on each
/// side is divided into bands by the distance from the loop; the width of a band is half the length
/// of the loop. The surface widens if a band has at least twice the area that it would have on a
/// cylinder whose circumference is the length of the loop. Cost: for each vertex the number of
/// vertices within half the largest length, and for each loop the number of faces up to the band at
/// which the surface widens. Deterministic for any number of threads.
#pragma once

#include <unordered_set>
#include <vector>

#include "fill/halfedge_stars.h"
#include "transformesh/control.h"

namespace transformesh {

struct NeckLoop {
  /// Vertices in order along the loop; at least three, and all different.
  std::vector<Index> vertices;
  double length = 0;
};

/// Returns loops of at most `max_length`, the shortest first. They do not bound a disk of faces
/// within half of `max_length`. Loops of equal length are sorted by their vertices. Not all
/// returned loops are around necks; NeckTest decides.
std::vector<NeckLoop> narrow_loops(const Mesh& mesh, const HalfedgeStars& stars, double max_length,
                                   const Progress& progress = Progress());

/// Tests whether a loop is around a neck, and not around a thin protrusion or a bump. The surface
/// may have been cut along other loops.
class NeckTest {
 public:
  /// Keeps references to both arguments. Precondition: `stars` is valid at all vertices that are
  /// not next to a cut.
  NeckTest(const Mesh& mesh, const HalfedgeStars& stars) : mesh_(mesh), stars_(stars) {}

  /// True if the surface widens on both sides of a loop. Faces beyond a recorded cut do not count.
  bool is_neck(const NeckLoop& loop) const;
  /// Records a cut along a loop. Must be called before the surface is cut along the loop.
  void note_cut(const NeckLoop& loop);

 private:
  std::vector<Index> halfedges_of(const NeckLoop& loop) const;
  bool widens(double length, const std::vector<Index>& start,
              const std::unordered_set<Index>& barred) const;
  Vec3 centroid(Index face) const;

  const Mesh& mesh_;
  const HalfedgeStars& stars_;
  std::unordered_set<Index> cuts_;  ///< halfedges along recorded cuts, in both directions
};

}  // namespace transformesh
