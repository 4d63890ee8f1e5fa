#include "clean/stitch/separate.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "clean/intersect/contacts.h"
#include "geometry/search/bvh.h"
#include "mesh/adjacency.h"
#include "mesh/coordinate_spacing.h"
#include "mesh/local_measures.h"
#include "support/elementary/arctangent.h"

namespace transformesh {
namespace {

/// Largest number of times that a vertex's movement is halved. If the movement is still invalid at
/// 1/1024 of its length, the vertex stays. A choice: with more halvings, more vertices move by tiny
/// distances.
constexpr int most_halvings = 10;

// The cone of the faces around a vertex. Its apex is the vertex, and each face is a side.
struct Cone {
  struct Side {
    Vec3 first, second;  ///< unit vectors from the vertex along both edges of the face
    Vec3 normal;         ///< unit normal of the face
  };
  std::vector<Side> sides;
  Vec3 normal = Vec3::Zero();  ///< unit mean of the face normals, weighted by corner angles
  Vec3 axis = Vec3::Zero();    ///< unit mean direction into the faces, weighted by corner angles
};

Cone cone_at(const Mesh& mesh, Index vertex, std::span<const Index> faces) {
  Cone cone;
  const Vec3& apex = mesh.positions[vertex];
  for (const Index f : faces) {
    const Face& face = mesh.faces[f];
    const std::size_t i = face[0] == vertex ? 0 : face[1] == vertex ? 1 : 2;
    const Vec3 first = (mesh.positions[face[(i + 1) % 3]] - apex).stableNormalized();
    const Vec3 second = (mesh.positions[face[(i + 2) % 3]] - apex).stableNormalized();
    const Vec3 normal = first.cross(second).stableNormalized();
    cone.sides.push_back({first, second, normal});
    const double angle = elementary::atan2(first.cross(second).norm(), first.dot(second));
    cone.normal += angle * normal;
    cone.axis += angle * (first + second).stableNormalized();
  }
  cone.normal = cone.normal.stableNormalized();
  cone.axis = cone.axis.stableNormalized();
  return cone;
}

// Returns the point of a side of a cone that is nearest to a unit vector. The side is an infinite
// planar sector with its apex at the origin.
Vec3 nearest_in_side(const Cone::Side& side, const Vec3& direction) {
  Vec3 in_plane = direction - direction.dot(side.normal) * side.normal;
  const bool is_left = side.normal.dot(side.first.cross(in_plane)) >= 0;
  const bool is_right = side.normal.dot(in_plane.cross(side.second)) >= 0;
  if (is_left && is_right) return in_plane;
  const double along_first = std::max(0.0, side.first.dot(direction));
  const double along_second = std::max(0.0, side.second.dot(direction));
  return along_first > along_second ? Vec3(along_first * side.first)
                                    : Vec3(along_second * side.second);
}

// Returns a positive value if the direction points to the front side of the cone of faces, and a
// negative value if it points to the back side. The sign is computed by angle-weighted
// pseudonormals (Baerentzen & Aanaes 2005). For directions close to the cone, the sign may be wrong
// because of rounding. A wrong sign can only have the effect that the vertex stays.
double side_of(const Cone& cone, const Vec3& direction) {
  constexpr double same = 1e-12;  // distances with a smaller difference are equal up to rounding
  // Least distance of `direction` from a side tested so far; initially from the apex.
  double least = 1 - same;
  Vec3 nearest = Vec3::Zero();
  Vec3 normal = cone.normal;
  for (const Cone::Side& side : cone.sides) {
    const Vec3 point = nearest_in_side(side, direction);
    const double distance = (direction - point).norm();
    if (distance > least + same) continue;
    if (distance < least - same) normal.setZero();
    normal += side.normal;
    least = std::min(least, distance);
    nearest = point;
  }
  return normal.dot(direction - nearest);
}

bool lies_in_tetrahedron(const Vec3& point, const std::array<Vec3, 4>& corners) {
  const auto& [a, b, c, d] = corners;
  const int whole = orient3d(a, b, c, d);
  return whole != 0 && orient3d(point, b, c, d) * whole >= 0 &&
         orient3d(a, point, c, d) * whole >= 0 && orient3d(a, b, point, d) * whole >= 0 &&
         orient3d(a, b, c, point) * whole >= 0;
}

class Separator {
 public:
  Separator(Mesh& mesh, const SeparateOptions& options)
      : mesh_(mesh), options_(options), faces_at_(mesh), is_border_(mesh.positions.size(), 0) {
    const std::vector<Index> opposite = opposite_halfedges(mesh);
    for (Index h = 0; h < opposite.size(); ++h) {
      if (opposite[h] != no_index) continue;
      is_border_[halfedge_source(mesh, h)] = is_border_[halfedge_target(mesh, h)] = 1;
    }
  }

  SeparateResult run(const Progress& progress) {
    std::vector<std::vector<Index>> groups = find_groups();
    if (groups.empty()) return {};
    bvh_ = Bvh(mesh_);
    was_moved_.assign(mesh_.positions.size(), 0);
    while (!groups.empty()) {
      reach_ += options_.distance;
      bool any = false;
      for (std::size_t g = 0; g < groups.size(); ++g) {
        progress("separate", static_cast<double>(g) / static_cast<double>(groups.size()));
        any |= move_apart(groups[g]);
      }
      groups = find_groups();
      if (!any && tries_all_) break;
      tries_all_ = !any;
    }
    SeparateResult result;
    for (const auto& group : groups) result.refused_vertices += group.size();
    result.separated_vertices =
        static_cast<std::size_t>(std::count(was_moved_.begin(), was_moved_.end(), 1));
    return result;
  }

 private:
  // Returns the sets of vertices with equal positions, with at least two vertices each.
  std::vector<std::vector<Index>> find_groups() const {
    std::vector<Index> order;
    for (Index v = 0; v < mesh_.positions.size(); ++v) {
      if (!faces_at_[v].empty()) order.push_back(v);
    }
    const auto& p = mesh_.positions;
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
      const int sign = compare_positions(p[a], p[b]);
      return sign != 0 ? sign < 0 : a < b;
    });
    std::vector<std::vector<Index>> groups;
    for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
      while (last < order.size() && p[order[last]] == p[order[first]]) ++last;
      if (last - first > 1) groups.emplace_back(order.begin() + first, order.begin() + last);
    }
    std::sort(groups.begin(), groups.end());
    return groups;
  }

  // Moves vertices at the same position (copies) apart. All directions are chosen before any copy
  // moves. Returns true if a copy moved.
  bool move_apart(const std::vector<Index>& copies) {
    std::vector<std::vector<Vec3>> directions;
    directions.reserve(copies.size());
    for (const Index copy : copies) directions.push_back(ways_out(copy, copies));
    bool any = false;
    for (std::size_t i = 0; i < copies.size(); ++i) {
      const auto leads_out = [&](const Vec3& direction) { return move(copies[i], direction); };
      if (std::none_of(directions[i].begin(), directions[i].end(), leads_out)) continue;
      was_moved_[copies[i]] = 1;
      any = true;
    }
    return any;
  }

  // Returns the directions, as unit vectors, in which the vertex may move away from the other
  // vertices at its position (copies). Empty if other copies have faces on both sides of its faces.
  std::vector<Vec3> ways_out(Index vertex, const std::vector<Index>& copies) const {
    if (is_border_[vertex]) return {};
    const Cone cone = cone_at(mesh_, vertex, faces_at_[vertex]);
    // At the edge of a thin part, the normals of both sides cancel each other. Then only the mean
    // direction into the faces (`axis`) points into the part.
    if (tries_all_) return {-cone.normal, cone.normal, cone.axis, -cone.axis};
    bool in_front = false;
    bool behind = false;
    for (const Index copy : copies) {
      if (copy == vertex) continue;
      for (const Index f : faces_at_[copy]) {
        const Vec3 direction = face_middle(mesh_, f) - mesh_.positions[vertex];
        (side_of(cone, direction.stableNormalized()) > 0 ? in_front : behind) = true;
      }
    }
    if (in_front && behind) return {};
    return {behind ? cone.normal : Vec3(-cone.normal)};
  }

  bool move(Index vertex, const Vec3& direction) {
    const Vec3 start = mesh_.positions[vertex];
    const std::vector<Index> near = faces_near(vertex);
    double step = options_.distance / 2;
    for (int halving = 0; halving <= most_halvings; ++halving, step /= 2) {
      Vec3 target = start + step * direction;
      if (options_.coordinate == Scalar::float32) {
        for (double& x : target) x = round_to_single(x);
      }
      if (!is_sound(vertex, target, near)) continue;
      mesh_.positions[vertex] = target;
      return true;
    }
    return false;
  }

  // Returns the faces without this vertex that its own faces may touch after the vertex moved.
  std::vector<Index> faces_near(Index vertex) const {
    Vec3 low = mesh_.positions[vertex];
    Vec3 high = low;
    for (const Index f : faces_at_[vertex]) {
      for (const Index v : mesh_.faces[f]) {
        low = low.cwiseMin(mesh_.positions[v]);
        high = high.cwiseMax(mesh_.positions[v]);
      }
    }
    const Vec3 reach = Vec3::Constant(2 * reach_);
    std::vector<Index> near;
    bvh_.visit_overlaps(float_box(low - reach, high + reach), [&](Index f) {
      const Face& face = mesh_.faces[f];
      if (std::find(face.begin(), face.end(), vertex) == face.end()) near.push_back(f);
      return true;
    });
    std::sort(near.begin(), near.end());
    return near;
  }

  // Returns the face with its corner at `vertex` moved to `target`.
  Triangle moved(Index f, Index vertex, const Vec3& target) const {
    Triangle result = triangle_of(mesh_, f);
    for (std::size_t i = 0; i < 3; ++i) {
      if (mesh_.faces[f][i] == vertex) result[i] = target;
    }
    return result;
  }

  bool is_sound(Index vertex, const Vec3& target, const std::vector<Index>& near) const {
    if (!target.allFinite()) return false;
    for (const Index f : faces_at_[vertex]) {
      if (normals_dot(triangle_of(mesh_, f), moved(f, vertex, target)) <= 0) return false;
    }
    for (const Index f : near) {
      for (const Index v : mesh_.faces[f]) {
        if (mesh_.positions[v] == target) return false;
      }
    }
    return !passes_any(vertex, target, near) && !meets_any(vertex, target, near);
  }

  // True if a face in `near` is inside the volume that the faces of the vertex sweep when it moves
  // to `target`. No face in `near` intersects the faces of the vertex before or after the movement,
  // so testing one point of each face is enough.
  bool passes_any(Index vertex, const Vec3& target, const std::vector<Index>& near) const {
    for (const Index f : faces_at_[vertex]) {
      const Face& face = mesh_.faces[f];
      const std::size_t i = face[0] == vertex ? 0 : face[1] == vertex ? 1 : 2;
      const std::array<Vec3, 4> swept{mesh_.positions[vertex], target,
                                      mesh_.positions[face[(i + 1) % 3]],
                                      mesh_.positions[face[(i + 2) % 3]]};
      for (const Index g : near) {
        if (lies_in_tetrahedron(face_middle(mesh_, g), swept)) return true;
      }
    }
    return false;
  }

  bool meets_any(Index vertex, const Vec3& target, const std::vector<Index>& near) const {
    Mesh local;
    const auto add = [&](const Triangle& corners) {
      const auto base = static_cast<Index>(local.positions.size());
      local.positions.insert(local.positions.end(), corners.begin(), corners.end());
      local.faces.push_back({base, base + 1, base + 2});
    };
    for (const Index f : faces_at_[vertex]) add(moved(f, vertex, target));
    for (const Index f : near) add(triangle_of(mesh_, f));
    const WeldedMesh welded = weld(local);
    for (Index f = 0; f < faces_at_[vertex].size(); ++f) {
      for (Index g = f + 1; g < welded.faces.size(); ++g) {
        if (find_contacts(welded, f, g).meet) return true;
      }
    }
    return false;
  }

  Mesh& mesh_;
  SeparateOptions options_;
  VertexFaces faces_at_;
  std::vector<char> is_border_;
  std::vector<char> was_moved_;
  Bvh bvh_;  ///< tree of the bounding boxes of the faces at their initial positions
  /// True if a vertex tries four directions: both directions along the mean normal, and both along
  /// the mean direction into its faces. Set if no vertex could move away from its copies.
  bool tries_all_ = false;
  /// Upper bound of the distance of any vertex from its position in the input, including the next
  /// movement.
  double reach_ = 0;
};

}  // namespace

SeparateResult separate(Mesh& mesh, const SeparateOptions& options, const Progress& progress) {
  return Separator(mesh, options).run(progress);
}

}  // namespace transformesh
