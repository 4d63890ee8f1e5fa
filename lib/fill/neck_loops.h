/// Short loops of edges around necks: places where a surface is narrower than on either side. Loops
/// around handles that are as narrow are found, too; those around fingers and bumps are not.
///
/// From every vertex shortest paths are grown up to half the length. Where the vertices reached lie
/// around a neck, the faces between them form a ring rather than a disk. A tree of paths and a tree
/// of faces then leave an edge that closes a loop around it (Erickson and Whittlesey, Greedy
/// optimal homotopy and homology generators, SODA 2005).
///
/// A loop is around a neck if the surface widens on both sides. It is divided into bands by the
/// distance from the loop, each half the loop's length wide. The surface widens if a band has twice
/// the area that it would have on a cylinder.
/// Cost: n times the size of a ball of half the length, and for each loop the faces up to where
/// the surface widens. Deterministic for any number of threads.
#pragma once

#include <unordered_set>
#include <vector>

#include "fill/halfedge_stars.h"
#include "transformesh/control.h"

namespace transformesh {

struct NeckLoop {
  std::vector<Index> vertices;  ///< in order, each once; at least three
  double length = 0;
};

/// Returns loops of at most that length which do not bound a disk near by, the shortest first, of
/// equal ones that of the lower vertices. Not all of them are around necks.
std::vector<NeckLoop> narrow_loops(const Mesh& mesh, const HalfedgeStars& stars, double max_length,
                                   const Progress& progress = Progress());

/// Tells necks from fingers and bumps, also after cuts along other loops.
class NeckTest {
 public:
  /// Keeps references. Pre: the stars are right at all vertices that are next to no cut.
  NeckTest(const Mesh& mesh, const HalfedgeStars& stars) : mesh_(mesh), stars_(stars) {}

  /// Whether the surface widens on both sides of a loop, up to the cuts.
  bool is_neck(const NeckLoop& loop) const;
  /// To be called before the surface is cut along a loop.
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
