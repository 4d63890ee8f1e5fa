/// What is around a part of a closed mesh that is cleaned alone, so that winding numbers are those
/// of the whole mesh. Deterministic.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "geometry/numbers/predicates.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Faces of a mesh as rays along the axes meet them: for each axis sorted along another one, which
/// takes a few bytes for each face that such a ray can reach.
class FarFaces {
 public:
  FarFaces() = default;
  /// Those that are not left out, for rays that start between two corners of a box. Keeps a
  /// reference to the mesh. Cost: O(n log n).
  FarFaces(const Mesh& mesh, const std::vector<bool>& left_out, const Vec3& low, const Vec3& high);

  /// Calls visit(triangle) for all that meet a box around a ray along the axis, and for some
  /// others, until it returns false.
  void visit_overlaps(const Vec3& low, const Vec3& high, int axis,
                      const std::function<bool(const Triangle&)>& visit) const;

 private:
  struct Entry {
    float least, most;  ///< along the axis of sorting; `most` is that of all entries up to this
    Index face;
  };

  const Mesh* mesh_ = nullptr;
  std::array<std::vector<Entry>, 3> along_;  ///< per axis of a ray
};

struct Surroundings {
  /// Per welded face: all faces that meet it, or that meet one of these, are in the part. Only such
  /// faces are arranged.
  std::vector<char> is_complete;
  FarFaces faces;  ///< all others of the mesh
};

}  // namespace transformesh
