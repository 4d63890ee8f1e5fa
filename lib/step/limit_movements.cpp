#include "step/limit_movements.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "geometry/keep_out.h"
#include "mesh/adjacency.h"
#include "mesh/coordinate_spacing.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t faces_per_task = 256;  ///< affects time only
/// From this many halvings on, at 1/32 of its movement, a vertex stops if its movement is also
/// smaller than the gap. More halvings leave smaller remaining gaps and take more tests.
constexpr int least_halvings = 5;
/// A vertex stops after this many halvings, at a billionth of its movement. It bounds the tests for
/// tiny gaps.
constexpr int most_halvings = 30;

class Holder {
 public:
  Holder(const Mesh& mesh, const KeepOutOptions& keep_out, Scalar coordinate,
         std::vector<Vec3>& movements)
      : mesh_(mesh), keep_out_(keep_out), coordinate_(coordinate), movements_(movements) {}

  LimitedMovements run() {
    LimitedMovements result;
    result.near = keep_out_.count_near(mesh_);
    const VertexFaces faces_at(mesh_);
    std::vector<int> halvings(movements_.size(), 0);
    std::vector<Index> asked(mesh_.faces.size());
    std::iota(asked.begin(), asked.end(), Index{0});
    while (!asked.empty()) asked = hold_back_at(refused(asked), halvings, faces_at);
    result.held_back = static_cast<std::size_t>(
        std::ranges::count_if(halvings, [](int count) { return count > 0; }));
    return result;
  }

 private:
  Vec3 goal(Index v) const {
    return moved_position(mesh_.positions[v], movements_[v], coordinate_);
  }

  std::vector<Index> refused(const std::vector<Index>& faces) const {
    std::vector<char> may(faces.size());
    parallel_for(faces.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) may[i] = may_move(faces[i]) ? 1 : 0;
    });
    std::vector<Index> refused;
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (may[i] == 0) refused.push_back(faces[i]);
    return refused;
  }

  bool may_move(Index face) const {
    const Triangle before = triangle_of(mesh_, face);
    const Face& corners = mesh_.faces[face];
    const Triangle after{goal(corners[0]), goal(corners[1]), goal(corners[2])};
    double farthest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      farthest = std::max(farthest, (after[i] - before[i]).norm());
    if (farthest == 0) return true;
    const double reach = farthest + keep_out_.gap();
    if (keep_out_.distance(before, reach) >= reach) return true;
    const auto sides = swept_sides(corners, before, after);
    return keep_out_.allows({&after, 1}, {&before, 1}, sides);
  }

  // Returns the sides of the prism that a face sweeps. The diagonal of each side goes from the old
  // position of the vertex with the lower index to the new position of the other vertex. Prisms of
  // adjacent faces thus share their side.
  static std::array<Triangle, 6> swept_sides(const Face& corners, const Triangle& before,
                                             const Triangle& after) {
    std::array<Triangle, 6> sides;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (corners[i] < corners[j]) {
        sides[2 * i] = {before[i], before[j], after[j]};
        sides[2 * i + 1] = {before[i], after[j], after[i]};
      } else {
        sides[2 * i] = {before[i], before[j], after[i]};
        sides[2 * i + 1] = {before[j], after[j], after[i]};
      }
    }
    return sides;
  }

  bool stops(Index v, int halvings) const {
    if (halvings <= least_halvings) return false;
    return halvings > most_halvings || movements_[v].norm() < keep_out_.gap();
  }

  // Halves the movements of the vertices of `faces`. Returns all faces at these vertices.
  std::vector<Index> hold_back_at(const std::vector<Index>& faces, std::vector<int>& halvings,
                                  const VertexFaces& faces_at) {
    std::vector<Index> vertices;
    for (const Index face : faces)
      for (const Index v : mesh_.faces[face])
        if (movements_[v] != Vec3::Zero()) vertices.push_back(v);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::vector<Index> touched;
    for (const Index v : vertices) {
      movements_[v] *= stops(v, ++halvings[v]) ? 0 : 0.5;
      touched.insert(touched.end(), faces_at[v].begin(), faces_at[v].end());
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    return touched;
  }

  const Mesh& mesh_;
  KeepOut keep_out_;
  Scalar coordinate_;
  std::vector<Vec3>& movements_;
};

}  // namespace

Vec3 moved_position(const Vec3& position, const Vec3& movement, Scalar coordinate) {
  return movement == Vec3::Zero() ? position : rounded_to(position + movement, coordinate);
}

LimitedMovements limit_movements(const Mesh& mesh, const KeepOutOptions& keep_out,
                                 Scalar coordinate, std::vector<Vec3>& movements) {
  return Holder(mesh, keep_out, coordinate, movements).run();
}

}  // namespace transformesh
