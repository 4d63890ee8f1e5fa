/// Short loops of edges around necks: places where a surface is narrower than on either side. Loops
/// around handles that are as narrow are found, too. Loops around thin protrusions and bumps are
/// not found.
///
/// Shortest paths are grown from every vertex up to half the length of a loop. If the reached
/// vertices lie around a neck, the faces between them form a ring instead of a disk. Such a ring
/// has an edge in neither a tree of paths nor a tree of faces, and this edge closes a loop.
/// Reference: Erickson and Whittlesey, Greedy optimal homotopy and homology generators, SODA 2005.
///
/// A loop is around a neck if the surface widens on both sides. The surface on each side is divided
/// into bands by the distance from the loop, each half the loop's length wide. The surface widens
/// if a band has twice the area that it would have on a cylinder whose circumference is the loop's
/// length. Cost: n times the size of a ball of half the length, and for each loop the faces up to
/// where the surface widens. Deterministic for any number of threads.
#pragma once

#include <unordered_set>
#include <vector>

#include "fill/halfedge_stars.h"
#include "transformesh/control.h"

namespace transformesh {

struct NeckLoop {
  std::vector<Index> vertices;  ///< vertices in order along the loop, each once; at least three
  double length = 0;
};

/// Returns loops of at most `max_length` that bound no disk nearby, the shortest first. Loops of
/// equal length are sorted by their vertices. Not all loops are around necks.
std::vector<NeckLoop> narrow_loops(const Mesh& mesh, const HalfedgeStars& stars, double max_length,
                                   const Progress& progress = Progress());

/// Distinguishes necks from thin protrusions and bumps, also after cuts along other loops.
class NeckTest {
 public:
  /// Keeps references. Pre: the stars are valid at all vertices that are not next to a cut.
  NeckTest(const Mesh& mesh, const HalfedgeStars& stars) : mesh_(mesh), stars_(stars) {}

  /// True if the surface widens on both sides of a loop before it reaches a cut.
  bool is_neck(const NeckLoop& loop) const;
  /// Records a cut. Must be called before the surface is cut along the loop.
  void note_cut(const NeckLoop& loop);

 private:
  std::vector<Index> halfedges_of(const NeckLoop& loop) const;
  bool widens(double length, const std::vector<Index>& start,
              const std::unordered_set<Index>& barred) const;
  Vec3 centroid(Index face) const;

  const Mesh& mesh_;
  const HalfedgeStars& stars_;
  std::unordered_set<Index> cuts_;  ///< halfedges along cuts
};

}  // namespace transformesh
