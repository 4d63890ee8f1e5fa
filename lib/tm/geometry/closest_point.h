/// The closest point of a triangle mesh, and on which side of it a query lies.
/// Reference for the sign: Baerentzen & Aanaes, "Signed distance computation using the angle
/// weighted pseudonormal", TVCG 2005. Floating point; deterministic; the face of lowest index wins
/// ties. Cost: O(log n) a query on usual meshes.
#pragma once

#include "tm/geometry/bvh.h"
#include "tm/mesh/mesh.h"

namespace transformesh {

struct ClosestPoint {
  Vec3 point = Vec3::Zero();
  Index face = no_index;
  double distance = 0;
  Vec3 pseudonormal = Vec3::Zero();  ///< of the face, edge or vertex hit; unit length
  /// Negative inside, by the pseudonormal.
  double signed_distance = 0;
};

class ClosestPointQuery {
 public:
  /// Keeps a reference to the mesh. Throws InputError for a mesh without faces.
  explicit ClosestPointQuery(const Mesh& mesh);
  ClosestPoint operator()(const Vec3& query) const;

 private:
  const Mesh* mesh_;
  Bvh bvh_;
  std::vector<Vec3> face_normals_;
  std::vector<Vec3> vertex_normals_;
  std::vector<Vec3> halfedge_normals_;
};

/// The point of triangle abc closest to the query.
Vec3 closest_point_of_triangle(const Vec3& query, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace transformesh
