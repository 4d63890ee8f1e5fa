/// Reference points in a part of a mesh: points off the surface, beside any complete face, with
/// their winding numbers in the whole mesh. They are found by a way through covered cells, from
/// the reference point of the part. Exact. Thread-safe: points depend on the order of calls, but
/// winding numbers do not.
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
  /// Calls a function for all faces of the part that touch a box, until it returns false.
  using VisitFaces = std::function<void(const Vec3& low, const Vec3& high, const Visit& visit)>;

  /// Keeps a reference.
  LocalReferences(const Surroundings& around, VisitFaces visit_faces)
      : around_(around), visit_faces_(std::move(visit_faces)) {}

  /// Returns a point in the cell of a place, another one for each attempt. The part has every face
  /// between the two. Empty if no way to the cell is found.
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
