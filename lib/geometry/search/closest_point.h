/// Closest point on a triangle mesh, with signed distance. Vertices are equal if their indices are;
/// for a soup without shared indices the sign is that of single faces. Floating point;
/// deterministic; ties are broken by the lowest face index. Thread-safe. Cost: O(n log n) to build
/// on all allowed threads; O(log n) per query on usual meshes. Reference for the sign: Baerentzen &
/// Aanaes, "Signed distance computation using the angle weighted pseudonormal", TVCG 11(3), 2005.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/search/median_tree.h"
#include "mesh/adjacency.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// The simplex of a triangle that contains a point: corner i, the edge from corner i to the next
/// corner, or the inside.
enum class TriangleSimplex { corner_0, corner_1, corner_2, edge_0, edge_1, edge_2, inside };

struct TrianglePoint {
  Vec3 point = Vec3::Zero();
  TriangleSimplex part = TriangleSimplex::inside;
};

/// Returns the point of triangle abc closest to the query. Triangles without area are treated as
/// segments or points.
TrianglePoint closest_point_of_triangle(const Vec3& query, const Vec3& a, const Vec3& b,
                                        const Vec3& c);

struct ClosestPoint {
  Vec3 point = Vec3::Zero();
  Index face = no_index;
  double distance = 0;
  /// Unit pseudonormal of the face, edge or vertex that contains `point`; zero if it has no
  /// direction.
  Vec3 pseudonormal = Vec3::Zero();
  /// Distance of the query; negative if the query is behind the surface, inside of a closed mesh.
  double signed_distance = 0;
};

/// Order of the faces of a mesh. `spatial` means that the faces are in the order of
/// spatial_face_order(), so that the tree is built without sorting. If this is not true, queries
/// are correct but slow.
enum class FaceOrder { any, spatial };
std::vector<Index> spatial_face_order(const Mesh& mesh);

class ClosestPointQuery {
 public:
  /// Keeps a reference to the mesh. Throws InputError if the mesh has no faces.
  explicit ClosestPointQuery(const Mesh& mesh, FaceOrder order = FaceOrder::any);
  /// Returns the closest point. `hint` is a face that may be close, e.g. that of a nearby query; it
  /// affects only the time.
  ClosestPoint operator()(const Vec3& query, Index hint = no_index) const;
  /// Returns the closest point of the faces whose normals are at an angle of less than 90 degrees
  /// from `normal`. Considers all faces if there is no such face, or if `normal` is zero.
  ClosestPoint facing(const Vec3& query, const Vec3& normal) const;
  /// Type of the condition in the following query: true if face abc counts. The query returns the
  /// closest point within `distance` on the faces that count, or nothing if there is none.
  using Accept = std::function<bool(const Vec3& a, const Vec3& b, const Vec3& c)>;
  std::optional<Vec3> closest_within(const Vec3& query, double distance,
                                     const Accept& accept) const;
  /// Returns any face within `distance`, or no_index if there is none.
  Index face_within(const Vec3& query, double distance, Index hint = no_index) const;
  /// Returns the face of the closest point, or no_index if it is farther than `distance`.
  Index closest_face_within(const Vec3& query, double distance, Index hint = no_index) const;
  /// Returns a point of the mesh whose distance exceeds the least one by at most the fraction
  /// `tolerance`. Much faster than the exact query far from the mesh, where many points have nearly
  /// the same distance.
  Vec3 nearby(const Vec3& query, double tolerance) const;

 private:
  struct Hit;
  template <class Condition>
  Hit search(const Vec3& query, double shrink, const Condition& accept, Index hint = no_index,
             double squared_bound = std::numeric_limits<double>::infinity()) const;
  ClosestPoint described(const Vec3& query, const Hit& best) const;
  Vec3 pseudonormal(Index face, TriangleSimplex part) const;
  /// Returns the face across an edge. Returns no_index on a border, if more than two faces meet, or
  /// if both faces traverse the edge in the same direction.
  Index face_across(Index face, Index from, Index to) const;

  const Mesh* mesh_;
  MedianTree tree_;
  VertexFaces faces_at_;
};

}  // namespace transformesh
