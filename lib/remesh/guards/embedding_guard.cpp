#include "remesh/guards/embedding_guard.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "remesh/guards/slab.h"
#include "remesh/guards/triangle_box.h"
#include "remesh/halfedges/longest_edge.h"
#include "remesh/halfedges/valences.h"

namespace transformesh {
namespace {

/// Width of cells, in lengths of the longest edge: the sum of two distances. Most patches lie
/// within 0.9 lengths of their center. Each face that meets a ball has a corner within
/// `corner_reach` lengths of the ball.
constexpr double cell_edges = 1.5;
constexpr double corner_reach = 0.58;
/// The tree of faces is built after this number of visited cell vertices per face of the mesh,
/// which take as long as building it. Meshes with edges of similar length need fewer visits.
constexpr std::size_t scans_per_face = 16;
/// If more faces than this are near a patch at a vertex of high valence, contact is tested before
/// the certificates, because this test skips most faces at the vertex. Without that, a double cone
/// of 12,000 faces takes 17 times as long to decimate. Contact is tested last elsewhere: if it came
/// first, a sphere with narrow faces around a pole took 1.7 times as long. The number is chosen by
/// hand.
constexpr std::size_t many_near = 256;

Vec3 sum_of(const std::vector<Vec3>& vectors) {
  return std::accumulate(vectors.begin(), vectors.end(), Vec3(Vec3::Zero()));
}

}  // namespace

EmbeddingGuard::EmbeddingGuard(const EditableMesh& mesh, double longest_edge,
                               const KeepOut* keep_out, std::optional<double> longest_now)
    : mesh_(mesh),
      keep_out_(keep_out),
      longest_allowed_(longest_edge),
      longest_edge_(longest_now ? *longest_now : longest_edge_of(mesh)),
      cells_(mesh, cell_edges * std::max(longest_allowed_, longest_edge_)),
      stamp_(mesh.face_slots(), 0) {}

void EmbeddingGuard::commit(const Patch& patch) {
  longest_edge_ = std::max(longest_edge_, std::sqrt(patch.longest_squared));
  cells_.update(patch.center);
  cells_.restrict(patch.vertices, cone_, patch.longest_squared);
  if (!tree_) return;
  for (const Index face : patch.replaced) tree_->update(face);
  if (patch.replaced.empty())
    mesh_.for_each_outgoing(patch.center, [&](Index halfedge) { tree_->update(halfedge / 3); });
}

void EmbeddingGuard::count_scanned(std::size_t vertices) {
  scanned_ += vertices;
  if (scanned_ > scans_per_face * mesh_.face_slots() && !tree_) tree_.emplace(mesh_);
}

bool EmbeddingGuard::keeps_out(const Patch& patch) {
  std::vector<Index> faces = patch.replaced;  // may contain duplicates
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  std::vector<Triangle> replaced;
  replaced.reserve(faces.size());
  for (const Index face : faces) replaced.push_back(mesh_.triangle(face));
  if (keep_out_->allows(patch.made, replaced)) return true;
  ++kept_out_;
  return false;
}

bool EmbeddingGuard::allows_uncertified(const Patch& patch) {
  if (keep_out_ == nullptr) return is_embedded(patch);
  return (is_certified(patch) || is_embedded(patch)) && keeps_out(patch);
}

bool EmbeddingGuard::is_too_long(const Patch& patch) const {
  const double longest = std::max(longest_allowed_, longest_edge_);
  return !(patch.longest_squared <= longest * longest);
}

bool EmbeddingGuard::is_embedded(const Patch& patch) {
  if (is_too_long(patch)) return false;
  enclose(patch);
  if (!tree_ && is_seen_around(patch)) return true;
  const bool has_many = !find_faces_near(patch, many_near);
  const bool is_crowded = has_many && is_at_high_valence(patch);
  if (is_crowded && is_apart(patch)) return true;
  if (has_many && tree_) find_faces_near(patch, mesh_.face_slots());
  // A tree has no cells, which is_seen_around() needs. Hence the same certificate is tested with
  // the faces that the tree finds.
  const std::optional<Direction> direction = tree_ ? direction_of(patch) : std::nullopt;
  return (direction && is_seen_in_slab(patch, direction->unit)) || is_height_field(patch) ||
         (!is_crowded && is_apart(patch));
}

/// True if a vertex of the patch has many faces. The tree is then built if there is none.
bool EmbeddingGuard::is_at_high_valence(const Patch& patch) {
  const bool result = std::any_of(patch.vertices.begin(), patch.vertices.end(), [&](Index vertex) {
    return (tree_ ? tree_->valence(vertex) : mesh_.valence(vertex)) > usual_valence;
  });
  if (result && !tree_) tree_.emplace(mesh_);
  return result;
}

bool EmbeddingGuard::is_certified(const Patch& patch) {
  if (is_too_long(patch)) return false;
  cone_ = patch.cone ? *patch.cone : common_cone(patch.normals);
  if ((cone_ & cells_.cell_of(patch.center).cone_around) == 0) return false;
  return lies_within(cells_.cell_size() - corner_reach * longest_edge_, patch);
}

/// True if the ball with radius `radius` around the old center contains the old and the new patch.
bool EmbeddingGuard::lies_within(double radius, const Patch& patch) const {
  const double limit = radius * radius;
  const Vec3& center = mesh_.position(patch.center);
  if (!((patch.center_position - center).squaredNorm() <= limit)) return false;
  if (patch.reach_squared >= 0) return patch.reach_squared <= limit;
  return std::all_of(patch.vertices.begin(), patch.vertices.end(), [&](Index vertex) {
    return (mesh_.position(vertex) - center).squaredNorm() <= limit;
  });
}

/// The smallest slab perpendicular to the direction that contains the old and the new patch.
Slab EmbeddingGuard::slab_of(const Patch& patch, const Vec3& direction) const {
  Slab slab(direction);
  for (const Triangle& triangle : patch.made) slab.extend(triangle);
  for (const Index face : patch.replaced) slab.extend(mesh_.triangle(face));
  return slab;
}

/// True if the direction is in front of all near faces that meet the slab of the patch (slab_of()),
/// and these faces belong to the component of the patch.
bool EmbeddingGuard::is_seen_in_slab(const Patch& patch, const Vec3& direction) const {
  const Index component = cells_[patch.center].component;
  const Slab slab = slab_of(patch, direction);
  return std::all_of(near_.begin(), near_.end(), [&](Index face) {
    const Triangle triangle = mesh_.triangle(face);
    return !slab.meets(triangle) ||
           (cells_[mesh_.source(3 * face)].component == component && sees(direction, triangle));
  });
}

/// Tests the certificate of embedding_guard.h for another convex body: the intersection of
/// slab_of() with the bounding box of both patches. The mean normal must be in front of all faces
/// that meet this body.
bool EmbeddingGuard::is_height_field(const Patch& patch) const {
  if (cells_[patch.center].component == no_index) return false;
  const Vec3 direction = sum_of(patch.normals).normalized();
  return std::all_of(patch.made.begin(), patch.made.end(),
                     [&](const Triangle& triangle) { return sees(direction, triangle); }) &&
         std::all_of(patch.replaced.begin(), patch.replaced.end(),
                     [&](Index face) { return sees(direction, mesh_.triangle(face)); }) &&
         is_seen_in_slab(patch, direction);
}

/// Compares each new triangle with the other new triangles and with the faces that are not
/// replaced.
bool EmbeddingGuard::is_apart(const Patch& patch) {
  if (meet_each_other(patch.made)) return false;
  mark_replaced(patch);
  const auto is_apart_from = [&](const Triangle& triangle, Index face) {
    const Triangle other = mesh_.triangle(face);
    return !boxes_touch(triangle, other) || !may_touch(triangle, other);
  };
  return std::all_of(patch.made.begin(), patch.made.end(), [&](const Triangle& triangle) {
    if (tree_)
      return tree_->for_each_in_contact(triangle, [&](Index face) {
        return stamp_[face] == stamp_now_ || is_apart_from(triangle, face);
      });
    return std::all_of(near_.begin(), near_.end(),
                       [&](Index face) { return is_apart_from(triangle, face); });
  });
}

/// Computes the bounding box of the old and the new patch, and a larger box that contains a corner
/// of each face that meets the bounding box.
void EmbeddingGuard::enclose(const Patch& patch) {
  low_ = high_ = patch.center_position;
  const auto extend = [&](const Triangle& triangle) {
    low_ = low_.cwiseMin(lowest(triangle));
    high_ = high_.cwiseMax(highest(triangle));
  };
  for (const Triangle& triangle : patch.made) extend(triangle);
  for (const Index face : patch.replaced) extend(mesh_.triangle(face));
  const Vec3 reach = Vec3::Constant(corner_reach * longest_edge_);
  low_corner_ = low_ - reach;
  high_corner_ = high_ + reach;
}

/// Returns the direction of normal_cone.h that is nearest to the mean normal among those in front
/// of both patches.
std::optional<Direction> EmbeddingGuard::direction_of(const Patch& patch) const {
  NormalCone cone = cells_[patch.center].component == no_index ? 0 : cone_;
  for (const Index vertex : patch.vertices) cone &= cells_[vertex].cone;
  if (cone == 0) return std::nullopt;
  return nearest_direction(cone, sum_of(patch.normals));
}

/// Proves that the patch is a height field, as is_height_field() does, but in the direction of
/// direction_of(). Cells and vertices whose normal cones contain this direction are skipped: their
/// faces need no test.
bool EmbeddingGuard::is_seen_around(const Patch& patch) {
  const std::optional<Direction> direction = direction_of(patch);
  if (!direction) return false;
  const Index component = cells_[patch.center].component;
  const auto is_alike = [&](const auto& part) {
    return part.component == component && (part.cone & direction->bit) != 0;
  };

  std::optional<Slab> slab;
  std::size_t scanned = 0;
  const bool result =
      cells_.for_each_cell_near(low_corner_, high_corner_, [&](const VertexCells::Cell& cell) {
        if (is_alike(cell)) return true;
        for (Index v = cell.first_vertex; v != no_index; v = cells_[v].next) {
          ++scanned;
          if (is_alike(cells_[v]) || !is_around(v)) continue;
          if (!slab) slab = slab_of(patch, direction->unit);
          if (!is_seen_or_far(v, component, *slab)) return false;
        }
        return true;
      });
  count_scanned(scanned);
  return result;
}

/// True if the slab's direction is in front of all faces at the vertex that meet both the slab and
/// the box of enclose(). If there are such faces, the vertex must belong to the component.
bool EmbeddingGuard::is_seen_or_far(Index vertex, Index component, const Slab& slab) const {
  const bool is_mine = cells_[vertex].component == component;
  bool result = true;
  mesh_.for_each_outgoing(vertex, [&](Index halfedge) {
    const Triangle triangle = mesh_.triangle(halfedge / 3);
    result = result && (!meets_box(triangle) || (is_mine && sees(slab.direction(), triangle)) ||
                        !slab.meets(triangle));
  });
  return result;
}

bool EmbeddingGuard::meets_box(const Triangle& triangle) const {
  return (lowest(triangle).array() <= high_.array()).all() &&
         (highest(triangle).array() >= low_.array()).all();
}

/// Calls visit(face) for all faces whose bounding boxes may meet the box of enclose(), some
/// repeatedly. A search in the tree ends if a call returns false.
template <class Visit>
void EmbeddingGuard::for_each_near(const Visit& visit) {
  if (tree_) {
    tree_->for_each_near(low_, high_, visit);
    return;
  }
  std::size_t scanned = 0;
  cells_.for_each_cell_near(low_corner_, high_corner_, [&](const VertexCells::Cell& cell) {
    for (Index v = cell.first_vertex; v != no_index; v = cells_[v].next) {
      ++scanned;
      if (!is_around(v)) continue;
      mesh_.for_each_outgoing(v, [&](Index halfedge) { visit(halfedge / 3); });
    }
    return true;
  });
  count_scanned(scanned);
}

/// Sets a new value of stamp_now_ as the stamp of the replaced faces.
void EmbeddingGuard::mark_replaced(const Patch& patch) {
  ++stamp_now_;
  for (const Index face : patch.replaced) stamp_[face] = stamp_now_;
}

/// Fills near_ with the faces that are not replaced and whose bounding boxes meet the box of
/// enclose(). Returns false if there are more than `most`; near_ is then incomplete.
bool EmbeddingGuard::find_faces_near(const Patch& patch, std::size_t most) {
  near_.clear();
  mark_replaced(patch);
  for_each_near([&](Index face) {
    if (stamp_[face] == stamp_now_) return true;
    stamp_[face] = stamp_now_;
    if (meets_box(mesh_.triangle(face))) near_.push_back(face);
    return near_.size() <= most;
  });
  return near_.size() <= most;
}

/// True if the vertex may be the nearest corner of a face that meets the box of enclose().
bool EmbeddingGuard::is_around(Index vertex) const {
  const Vec3& position = mesh_.position(vertex);
  const double longest = std::sqrt(static_cast<double>(cells_[vertex].longest_squared));
  const double reach = corner_reach * std::min(longest, longest_edge_);
  return (position.array() >= low_.array() - reach).all() &&
         (position.array() <= high_.array() + reach).all();
}

}  // namespace transformesh
