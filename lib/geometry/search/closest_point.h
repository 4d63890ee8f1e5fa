/// The closest point of a triangle mesh, and on which side of it a query lies.
/// Vertices are the same when their indices are: the sign of a soup whose faces share no indices is
/// that of single faces. Floating point; deterministic; the face of lowest index wins ties. Safe to
/// call from several threads at once.
/// Cost: O(n log n) to build on all allowed threads, O(log n) a query on usual meshes.
/// Reference for the sign: Baerentzen & Aanaes, "Signed distance computation using the angle
/// weighted pseudonormal", TVCG 11(3), 2005.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/search/median_tree.h"
#include "mesh/adjacency.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// The part of a triangle on which a point lies: corner i, the edge from corner i to the next, or
/// the inside.
enum class TriangleSimplex { corner_0, corner_1, corner_2, edge_0, edge_1, edge_2, inside };

struct TrianglePoint {
  Vec3 point = Vec3::Zero();
  TriangleSimplex part = TriangleSimplex::inside;
};

/// The point of triangle abc closest to the query. Triangles without area are segments or points.
TrianglePoint closest_point_of_triangle(const Vec3& query, const Vec3& a, const Vec3& b,
                                        const Vec3& c);

struct ClosestPoint {
  Vec3 point = Vec3::Zero();
  Index face = no_index;
  double distance = 0;
  Vec3 pseudonormal = Vec3::Zero();  ///< of the face, edge or vertex hit; unit length, or zero
  /// Negative inside, by the pseudonormal; of an open mesh, behind it.
  double signed_distance = 0;
};

/// How the faces of a mesh are ordered. `spatial` says that spatial_face_order() did it, which
/// saves the sorting; where that is not so, queries are right but slow.
enum class FaceOrder { any, spatial };
std::vector<Index> spatial_face_order(const Mesh& mesh);

class ClosestPointQuery {
 public:
  /// Keeps a reference to the mesh. Throws InputError for a mesh without faces.
  explicit ClosestPointQuery(const Mesh& mesh, FaceOrder order = FaceOrder::any);
  /// `hint`: a face that may be near, as that of a query nearby; it only saves time.
  ClosestPoint operator()(const Vec3& query, Index hint = no_index) const;
  /// The same among the faces whose normals are less than a right angle from that one, by more than
  /// rounding; among all where there is none, or the normal is zero.
  ClosestPoint facing(const Vec3& query, const Vec3& normal) const;
  /// The closest point of the faces abc that pass `accept` and come at least as near as
  /// `distance`; nothing if there is none.
  using Accept = std::function<bool(const Vec3& a, const Vec3& b, const Vec3& c)>;
  std::optional<Vec3> closest_within(const Vec3& query, double distance,
                                     const Accept& accept) const;
  /// A face that comes at least as near as that, the first that is met; no_index if there is none.
  Index face_within(const Vec3& query, double distance, Index hint = no_index) const;
  /// The face of the closest point; no_index if that is farther than `distance`.
  Index closest_face_within(const Vec3& query, double distance, Index hint = no_index) const;
  /// A point of the mesh that is farther than the closest by no more than that share of the
  /// distance. Much faster far from the mesh, where many points are almost the closest.
  Vec3 nearby(const Vec3& query, double tolerance) const;

 private:
  struct Hit;
  template <class Condition>
  Hit search(const Vec3& query, double shrink, const Condition& accept, Index hint = no_index,
             double squared_bound = std::numeric_limits<double>::infinity()) const;
  ClosestPoint described(const Vec3& query, const Hit& best) const;
  Vec3 pseudonormal(Index face, TriangleSimplex part) const;
  /// no_index on a border, if more than two faces meet and if both traverse the edge in the same
  /// direction.
  Index face_across(Index face, Index from, Index to) const;

  const Mesh* mesh_;
  MedianTree tree_;
  VertexFaces faces_at_;
};

}  // namespace transformesh
