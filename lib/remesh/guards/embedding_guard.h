/// Keeps a surface free of self-intersections while patches of it are replaced.
///
/// A patch is allowed at once by a certificate: where all faces that meet a ball have normals on
/// one side of a plane, a closed connected surface without self-intersections is a height field in
/// that ball (along the plane's normal its crossings alternate between in and out). A new patch
/// with the same rim whose normals are on that side too covers the same ground, so it cannot meet
/// the rest. Each cell of a grid keeps the normal cone of its faces (normal_cone.h), so that the
/// test of a whole neighborhood is one bitwise and. Where that fails, as between the sheets of a
/// thin plate, the faces around the patch's own box are asked one by one. Elsewhere, and near
/// borders or a second component, every new triangle is tested against all triangles nearby and
/// those of its own patch (triangle_contact.h).
///
/// Patches are also kept away from another surface, where one is given (keep_out.h).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/keep_out.h"
#include "remesh/guards/triangle_contact.h"
#include "remesh/halfedges/editable_mesh.h"
#include "remesh/halfedges/vertex_cells.h"

namespace transformesh {

/// A part of the surface about to be replaced by another with the same rim.
struct Patch {
  Index center = no_index;         ///< a living vertex of it, before and after
  Vec3 center_position;            ///< where it will be
  std::vector<Triangle> made;      ///< the new triangles
  std::vector<Vec3> normals;       ///< of these, of any length
  std::optional<NormalCone> cone;  ///< of the normals, if it is known: then the certificate does
                                   ///< without them
  double longest_squared = 0;      ///< of their edges
  double reach_squared = -1;    ///< from the center to the farthest of `vertices`; < 0: not known
  std::vector<Index> replaced;  ///< the faces that give way
  std::vector<Index> vertices;  ///< the corners of the new triangles
  /// Per new triangle of a collapse, the halfedge from the center of the face that becomes it.
  std::vector<Index> spokes;

  void clear();
};

class EmbeddingGuard {
 public:
  /// Keeps a reference to the mesh, whose faces and vertices may afterwards only be replaced by
  /// patches that were allowed. No new edge may be longer than the longest edge now or
  /// `longest_edge`. `longest_now`: that edge's length, if it is known.
  EmbeddingGuard(const EditableMesh& mesh, double longest_edge, const KeepOut* keep_out = nullptr,
                 std::optional<double> longest_now = std::nullopt);

  /// Whether the patch certainly meets nothing but its rim and does not fold onto itself. Contact
  /// within rounding error counts as meeting.
  bool allows(const Patch& patch) { return certifies(patch) || allows_uncertified(patch); }
  /// Both parts of that: the second is asked where the first says no. The first does not look at
  /// the triangles made and the faces replaced, and says no where there is a surface to keep out
  /// of.
  bool certifies(const Patch& patch) { return keep_out_ == nullptr && is_certified(patch); }
  bool allows_uncertified(const Patch& patch);
  /// How many patches were refused only because of the surface to keep out of.
  std::size_t kept_out() const { return kept_out_; }
  /// To be called after the mesh was changed by the patch that was allowed last.
  void commit(const Patch& patch);
  void forget(Index vertex) { cells_.remove(vertex); }

 private:
  class Slab;

  bool is_too_long(const Patch& patch) const;
  bool lies_within(double radius, const Patch& patch) const;
  bool is_certified(const Patch& patch);
  bool is_embedded(const Patch& patch);
  bool keeps_out(const Patch& patch);
  void find_faces_near(const Patch& patch);
  void enclose(const Patch& patch);
  bool is_seen_around(const Patch& patch) const;
  bool is_seen_or_far(Index vertex, Index component, const Slab& slab) const;
  bool is_around(Index vertex) const;
  bool is_height_field(const Patch& patch) const;
  Slab slab_of(const Patch& patch, const Vec3& direction) const;
  bool meets_box(const Triangle& triangle) const;
  bool meets_others(const Patch& patch) const;

  const EditableMesh& mesh_;
  const KeepOut* keep_out_;
  std::size_t kept_out_ = 0;
  double longest_allowed_;
  double longest_edge_;  ///< that there is or has been
  VertexCells cells_;
  std::vector<std::uint32_t> stamp_;  ///< per face, against visiting twice
  std::uint32_t stamp_now_ = 0;
  NormalCone cone_ = 0;      ///< of the patch allowed last
  Vec3 low_ = Vec3::Zero();  ///< the box around the patch in question, before and after
  Vec3 high_ = Vec3::Zero();
  Vec3 low_corner_ = Vec3::Zero();  ///< the same box, wide enough for a corner of all faces in it
  Vec3 high_corner_ = Vec3::Zero();
  std::vector<Index> near_;  ///< faces whose boxes touch it
};

}  // namespace transformesh
