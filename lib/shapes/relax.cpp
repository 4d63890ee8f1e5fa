#include "shapes/relax.h"

#include <Eigen/Geometry>

#include "mesh/adjacency.h"
#include "mesh/triangle.h"
#include "support/parallel.h"

namespace transformesh::shapes {
namespace {

constexpr std::size_t vertices_per_task = 1024;  ///< affects time only

/// Returns the cosine of the angle at the apex.
double cosine_at(const Vec3& apex, const Vec3& a, const Vec3& b) {
  return (a - apex).dot(b - apex) / ((a - apex).norm() * (b - apex).norm());
}

class EdgeFlipper {
 public:
  explicit EdgeFlipper(Mesh& mesh)
      : mesh_(mesh), opposite_(opposite_halfedges(mesh)), valence_(mesh.positions.size(), 0) {
    for (const Face& face : mesh.faces)
      for (const Index vertex : face) ++valence_[vertex];
  }

  /// Tests every edge once, and flips the edges that improve.
  void flip_all(bool by_valence) {
    for (Index h = 0; h < opposite_.size(); ++h) {
      if (opposite_[h] < h) continue;
      const Diamond diamond = around(h);
      if ((by_valence ? improves_valence(diamond) : improves_angles(diamond)) &&
          is_legal(h, diamond))
        flip(h, diamond);
    }
  }

 private:
  /// The edge (a, b) with the opposite corners c, on its left, and d.
  struct Diamond {
    Index a, b, c, d;
  };

  Diamond around(Index h) const {
    return {halfedge_source(mesh_, h), halfedge_target(mesh_, h),
            halfedge_source(mesh_, previous_halfedge(h)),
            halfedge_source(mesh_, previous_halfedge(opposite_[h]))};
  }

  bool improves_valence(const Diamond& e) const {
    const auto squared = [](int deviation) { return deviation * deviation; };
    const int a = valence_[e.a] - 6;
    const int b = valence_[e.b] - 6;
    const int c = valence_[e.c] - 6;
    const int d = valence_[e.d] - 6;
    return squared(a - 1) + squared(b - 1) + squared(c + 1) + squared(d + 1) <
           squared(a) + squared(b) + squared(c) + squared(d);
  }

  // Delaunay criterion: the two angles opposite to the edge sum to more than pi.
  bool improves_angles(const Diamond& e) const {
    const Vec3& a = mesh_.positions[e.a];
    const Vec3& b = mesh_.positions[e.b];
    return cosine_at(mesh_.positions[e.c], a, b) + cosine_at(mesh_.positions[e.d], a, b) < -1e-9;
  }

  // True if valences stay above three, the new edge does not exist, and no face is reversed.
  bool is_legal(Index h, const Diamond& e) const {
    if (valence_[e.a] <= 4 || valence_[e.b] <= 4 || are_neighbors(h, e.d)) return false;
    const Vec3& a = mesh_.positions[e.a];
    const Vec3& b = mesh_.positions[e.b];
    const Vec3& c = mesh_.positions[e.c];
    const Vec3& d = mesh_.positions[e.d];
    const Vec3 up = normal_of(a, b, c) + normal_of(b, a, d);
    const double enough = 0.2 * up.norm();
    const auto is_upright = [&](const Vec3& normal) {
      return normal.dot(up) > enough * normal.norm() && normal.norm() > 0.1 * up.norm();
    };
    return is_upright(normal_of(a, d, c)) && is_upright(normal_of(d, b, c));
  }

  // True if the vertex opposite to h in its face has an edge to `vertex`.
  bool are_neighbors(Index h, Index vertex) const {
    const Index start = previous_halfedge(h);
    Index spoke = start;
    do {
      if (halfedge_target(mesh_, spoke) == vertex) return true;
      spoke = opposite_[previous_halfedge(spoke)];
    } while (spoke != start);
    return false;
  }

  void flip(Index h, const Diamond& e) {
    const Index o = opposite_[h];
    const Index bc = opposite_[next_halfedge(h)];
    const Index ca = opposite_[previous_halfedge(h)];
    const Index ad = opposite_[next_halfedge(o)];
    const Index db = opposite_[previous_halfedge(o)];
    const Index left = h / 3;
    const Index right = o / 3;
    mesh_.faces[left] = {e.a, e.d, e.c};
    mesh_.faces[right] = {e.d, e.b, e.c};
    link(3 * left, ad);
    link(3 * left + 1, 3 * right + 2);
    link(3 * left + 2, ca);
    link(3 * right, db);
    link(3 * right + 1, bc);
    --valence_[e.a];
    --valence_[e.b];
    ++valence_[e.c];
    ++valence_[e.d];
  }

  void link(Index first, Index second) {
    opposite_[first] = second;
    opposite_[second] = first;
  }

  Mesh& mesh_;
  std::vector<Index> opposite_;
  std::vector<int> valence_;
};

/// Returns the center of the faces at a vertex, weighted by area.
Vec3 middle_around(const Mesh& mesh, std::span<const Index> faces) {
  Vec3 sum = Vec3::Zero();
  double weight = 0;
  for (const Index f : faces) {
    const auto& [a, b, c] = mesh.faces[f];
    const double area = normal_of(mesh.positions[a], mesh.positions[b], mesh.positions[c]).norm();
    sum += area / 3 * (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]);
    weight += area;
  }
  return sum / weight;
}

void smooth(Mesh& mesh, const std::function<Vec3(const Vec3&)>& project) {
  const VertexFaces faces_around(mesh);
  std::vector<Vec3> moved(mesh.positions.size());
  parallel_for(moved.size(), vertices_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v)
      moved[v] = project(middle_around(mesh, faces_around[static_cast<Index>(v)]));
  });
  mesh.positions = std::move(moved);
}

}  // namespace

void relax(Mesh& mesh, const std::function<Vec3(const Vec3&)>& project, int iterations,
           const Progress& progress) {
  EdgeFlipper flipper(mesh);
  for (int i = 0; i < iterations; ++i) {
    progress("relax", static_cast<double>(i) / iterations);
    flipper.flip_all(2 * i < iterations);
    smooth(mesh, project);
  }
}

}  // namespace transformesh::shapes
