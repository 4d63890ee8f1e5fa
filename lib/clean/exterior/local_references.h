/// Finds reference points in a part of a mesh: points off the surface whose winding numbers in the
/// whole mesh are known. They are found near faces whose surroundings are in the part
/// (`Surroundings::is_complete`). A path through cells in which the part has all faces leads from
/// the reference point of the part to the new point. Exact. Thread-safe: the points depend on the
/// order of calls, but the winding numbers do not. Cost: a new point takes a breadth-first search
/// of cells.
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <unordered_map>

#include "clean/exterior/surroundings.h"

namespace transformesh {

class LocalReferences {
 public:
  using Visit = std::function<bool(const Triangle&)>;
  /// Function that calls `visit` for all faces of the loaded part of the mesh that touch a box,
  /// until `visit` returns false.
  using VisitFaces = std::function<void(const Vec3& low, const Vec3& high, const Visit& visit)>;

  /// Keeps a reference to `around`.
  LocalReferences(const Surroundings& around, VisitFaces visit_faces)
      : around_(around), visit_faces_(std::move(visit_faces)) {}

  /// Returns a reference point in the grid cell of `place`; each value of `attempt` gives a
  /// different point. The faces near the box (`around`) include every face that the segment from
  /// `place` to this point can meet. Returns nothing if no path to the cell is found.
  std::optional<ReferencePoint> near(const Vec3& place, int attempt) const;

 private:
  std::optional<ReferencePoint> known(Cell cell) const;
  std::vector<Cell> way_to(Cell cell) const;
  bool enter(Cell cell) const;
  std::optional<ReferencePoint> find_in(const Eigen::AlignedBox3d& box, int first,
                                        const ReferencePoint& from) const;
  std::optional<int> change(const Vec3& from, const Vec3& to) const;

  const Surroundings& around_;
  VisitFaces visit_faces_;
  mutable std::mutex mutex_;
  mutable std::unordered_map<Cell, ReferencePoint> known_;
};

}  // namespace transformesh
