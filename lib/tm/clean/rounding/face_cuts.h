/// Points at which faces of a mesh are to be split, and their splitting: those on an edge split all
/// its faces, so that what is closed stays closed. Equal positions are one point.
/// Cost: O(n) for n faces, and that of FaceSplitter for each face with points. Deterministic.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tm/clean/intersect/soup.h"
#include "tm/clean/stitch/assemble.h"

namespace transformesh {

/// An edge as its points, the smaller one first.
using PointPair = std::array<Index, 2>;

inline PointPair edge_of(const Face& corners, std::size_t i) {
  const Index a = corners[i], b = corners[(i + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

class FaceCuts {
 public:
  /// The soup is that of the assembly's mesh; new positions are in numbers of that type. Keeps
  /// references to both.
  FaceCuts(Assembly& assembly, const Soup& soup, Scalar coordinate);

  std::size_t faces() const { return corners_.size(); }
  const Face& corners(Index face) const { return corners_[face]; }  ///< as points
  const Vec3& position(Index point) const { return points_[point]; }
  Triangle triangle(Index face) const;

  /// A point that is close to the edge, at that share of its length.
  void add_on_edge(const PointPair& edge, double share, Index point);
  /// A point that is close to the inside of the face.
  void add_inside(Index face, Index point);
  /// A new point where two edges pass each other; the same for the same two.
  Index point_between(const PointPair& first, const PointPair& second, const Vec3& position);
  /// Edges of the other face whose ends are then on the face become edges there.
  void constrain(Index face, Index other);
  /// Whole faces keep their order, pieces follow. Points inside a face that are closer than the
  /// distance to its other cuts go on them. What was added is spent.
  void split_faces(double distance);

 private:
  std::vector<std::pair<double, Index>> cuts_of(const PointPair& edge) const;
  std::vector<Index> chain_of(const PointPair& edge) const;
  std::set<Index> points_on(Index face) const;
  bool is_split(Index face) const;
  std::vector<Face> split(Index face, double distance) const;
  void add_vertices(const std::vector<Face>& pieces, const std::vector<Index>& rows);
  void replace_faces(std::vector<Face> faces, const std::vector<Index>& rows,
                     std::size_t first_piece);

  Assembly& assembly_;
  const Soup& soup_;
  const Scalar coordinate_;
  std::vector<Face> corners_;                             ///< of all faces, as points
  std::vector<Vec3> points_;                              ///< of the soup, then new ones
  std::map<PointPair, std::map<Index, double>> on_edge_;  ///< points, and at which share
  std::map<Index, std::set<Index>> inside_;               ///< points, per face
  std::map<Index, std::set<PointPair>> constraints_;      ///< per face
  std::map<std::array<PointPair, 2>, Index> between_;     ///< new points
};

}  // namespace transformesh
