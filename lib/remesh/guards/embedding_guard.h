/// Keeps a surface free of self-intersections while patches of it are replaced.
///
/// Most patches are allowed by a certificate. Suppose that all faces that meet a ball have normals
/// on one side of a plane. Then a closed connected surface without self-intersections is a height
/// field in the ball, because a line along the plane's normal enters and leaves the solid
/// alternately. A new patch with the same rim and with normals on the same side has the same
/// projection as the old patch, and cannot meet the rest of the surface.
///
/// There are three tests, from fast to slow:
/// - Each cell of a grid stores the normal cone of its faces (normal_cone.h). The test of a whole
///   neighborhood is one bitwise AND.
/// - If the first test fails, for example between the two sides of a thin plate, the certificate is
/// tested with the single faces around the bounding box of the patch.
/// - The last test is also used near borders and near a second component. It tests every new
/// triangle against all triangles nearby and against the other triangles of its patch
/// (triangle_contact.h).
///
/// The width of cells is proportional to the longest edge, so a cell of a mesh of slivers may have
/// thousands of faces. The second and third test then find near faces in a tree instead
/// (face_tree.h). If a vertex has thousands of faces, all of them are near each patch at the
/// vertex. The third test is then the first, because the tree skips faces that only share the
/// vertex.
///
/// If an obstacle is given, patches are also kept away from it (keep_out.h).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/keep_out.h"
#include "remesh/guards/face_tree.h"
#include "remesh/guards/slab.h"
#include "remesh/guards/triangle_contact.h"
#include "remesh/halfedges/editable_mesh.h"
#include "remesh/halfedges/vertex_cells.h"

namespace transformesh {

/// A replacement of a part of the surface by new triangles with the same rim.
struct Patch {
  Index center = no_index;     ///< a living vertex that belongs to the old and the new part
  Vec3 center_position;        ///< new position of the center
  std::vector<Triangle> made;  ///< new triangles
  std::vector<Vec3> normals;   ///< normals of the new triangles, of any length
  /// Cone of the normals, if known; the certificate then does not need `normals`.
  std::optional<NormalCone> cone;
  double longest_squared = 0;  ///< squared length of the longest new edge
  /// Squared distance of the farthest vertex from the center; < 0: unknown.
  double reach_squared = -1;
  std::vector<Index> replaced;  ///< replaced faces
  std::vector<Index> vertices;  ///< corners of the new triangles
  /// Only for collapses: for each new triangle, the halfedge of its old face that leaves the
  /// center.
  std::vector<Index> spokes;

  void clear() {
    made.clear();
    normals.clear();
    cone.reset();
    replaced.clear();
    vertices.clear();
    spokes.clear();
  }
};

class EmbeddingGuard {
 public:
  /// Keeps a reference to the mesh, which may afterwards be changed only by allowed patches. No new
  /// edge may be longer than both the current longest edge and `longest_edge`. `longest_now` is the
  /// length of the current longest edge, if known.
  EmbeddingGuard(const EditableMesh& mesh, double longest_edge, const KeepOut* keep_out = nullptr,
                 std::optional<double> longest_now = std::nullopt);

  /// True if the patch certainly meets the rest of the surface only at its rim, and does not
  /// intersect itself. Contact within rounding errors counts as intersection.
  bool allows(const Patch& patch) { return certifies(patch) || allows_uncertified(patch); }
  /// The two stages of allows(). allows_uncertified() is needed only if certifies() returns false.
  /// certifies() does not need `made` and `replaced`, and returns false if there is an obstacle.
  bool certifies(const Patch& patch) { return keep_out_ == nullptr && is_certified(patch); }
  bool allows_uncertified(const Patch& patch);
  /// Returns the number of patches that were refused only because of the obstacle.
  std::size_t kept_out() const { return kept_out_; }
  /// Call after the mesh was changed by the last allowed patch.
  void commit(const Patch& patch);
  void forget(Index vertex) { cells_.remove(vertex); }

 private:
  bool is_too_long(const Patch& patch) const;
  bool lies_within(double radius, const Patch& patch) const;
  bool is_certified(const Patch& patch);
  bool is_embedded(const Patch& patch);
  void count_scanned(std::size_t vertices);
  bool keeps_out(const Patch& patch);
  void mark_replaced(const Patch& patch);
  bool find_faces_near(const Patch& patch, std::size_t most);
  template <class Visit>
  void for_each_near(const Visit& visit);
  void enclose(const Patch& patch);
  std::optional<Direction> direction_of(const Patch& patch) const;
  bool is_seen_around(const Patch& patch);
  bool is_seen_or_far(Index vertex, Index component, const Slab& slab) const;
  bool is_around(Index vertex) const;
  bool is_seen_in_slab(const Patch& patch, const Vec3& direction) const;
  bool is_height_field(const Patch& patch) const;
  Slab slab_of(const Patch& patch, const Vec3& direction) const;
  bool meets_box(const Triangle& triangle) const;
  bool is_at_high_valence(const Patch& patch);
  bool is_apart(const Patch& patch);

  const EditableMesh& mesh_;
  const KeepOut* keep_out_;
  std::size_t kept_out_ = 0;
  double longest_allowed_;
  double longest_edge_;  ///< length of the longest edge so far
  VertexCells cells_;
  /// Finds near faces instead of the cells; set if cells were too slow.
  std::optional<FaceTree> tree_;
  std::size_t scanned_ = 0;           ///< vertices of cells visited so far
  std::vector<std::uint32_t> stamp_;  ///< `stamp_now_` for each face that was already visited
  std::uint32_t stamp_now_ = 0;
  NormalCone cone_ = 0;      ///< cone of the last allowed patch
  Vec3 low_ = Vec3::Zero();  ///< corners of the box around the old and the new part
  Vec3 high_ = Vec3::Zero();
  /// Corners of the box, enlarged to contain a corner of each near face.
  Vec3 low_corner_ = Vec3::Zero();
  Vec3 high_corner_ = Vec3::Zero();
  std::vector<Index> near_;  ///< faces whose bounding boxes touch the box from `low_` to `high_`
};

}  // namespace transformesh
