#include "shapes/lattice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "shapes/assembly.h"

namespace transformesh::shapes {
namespace {

/// Lattice points closer to the surface than this move onto it; in spacings. A choice.
constexpr double snap_distance = 0.55;

/// Integer coordinates of a lattice point: all even (corners of cubes) or all odd (centers).
using Site = std::array<int, 3>;

enum class Side { inside, on, outside };

struct LatticePoint {
  Vec3 position;
  double value;
  Side side;
  Index vertex = no_index;  ///< index in the mesh, if the point is on the surface
};

/// Up to four points of a tetrahedron, or corners of a cut polygon.
struct Selection {
  std::array<Index, 4> item;
  int size = 0;
  void add(Index index) { item[size++] = index; }
};

class Marcher {
 public:
  Marcher(const ImplicitSolid& solid, double spacing, unsigned variant)
      : solid_(solid), spacing_(spacing), turn_(generic_rotation(variant)) {}

  Mesh run() {
    int size = 4;
    while (size * spacing_ < 2 * std::sqrt(3.0) * solid_.half_width + 8 * spacing_) size *= 2;
    visit({-size / 2, -size / 2, -size / 2}, size);
    remove_membranes();
    return std::move(mesh_);
  }

 private:
  // The lattice is rotated and shifted away from typical symmetries of solids.
  Vec3 place(const Vec3& site) const {
    return spacing_ * (turn_ * site + Vec3(0.317, 0.731, 0.523));
  }
  Vec3 place(const Site& site) const { return place(Vec3(site[0], site[1], site[2])); }

  // Octree traversal. Skips cubes that cannot meet the surface, since the slope of the function is
  // at most 1.
  void visit(const Site& low, int size) {
    const Vec3 center = Vec3(low[0], low[1], low[2]) + Vec3::Constant(size / 2.0);
    const double reach = spacing_ * (std::sqrt(3.0) / 2 * size + 4);
    if (std::abs(solid_.function(place(center))) > reach) return;
    if (size == 2) return cut_tetrahedra(low);
    const int half = size / 2;
    for (int corner = 0; corner < 8; ++corner)
      visit({low[0] + (corner & 1) * half, low[1] + (corner >> 1 & 1) * half,
             low[2] + (corner >> 2 & 1) * half},
            half);
  }

  // Each cube edge belongs to four tetrahedra. The corners of each one are the two ends of the edge
  // and the centers of two adjacent cubes.
  void cut_tetrahedra(const Site& low) {
    for (int axis = 0; axis < 3; ++axis) {
      Site high = low;
      high[axis] += 2;
      constexpr std::array<std::array<int, 2>, 5> turn{
          {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 1}}};
      std::array<Index, 5> center;
      for (int i = 0; i < 5; ++i) {
        Site site = low;
        site[axis] += 1;
        site[(axis + 1) % 3] += turn[i][0];
        site[(axis + 2) % 3] += turn[i][1];
        center[i] = point(site);
      }
      for (int i = 0; i < 4; ++i) cut({point(low), point(high), center[i], center[i + 1]});
    }
  }

  Index point(const Site& site) {
    const auto part = [](int coordinate) {
      return static_cast<std::uint64_t>(coordinate + (1 << 20)) & 0x1fffff;
    };
    const std::uint64_t key = part(site[0]) << 42 | part(site[1]) << 21 | part(site[2]);
    const auto [entry, is_new] =
        point_of_site_.try_emplace(key, static_cast<Index>(points_.size()));
    if (is_new) points_.push_back(evaluated(place(site)));
    return entry->second;
  }

  LatticePoint evaluated(const Vec3& position) const {
    const double value = solid_.function(position);
    if (std::abs(value) < snap_distance * spacing_) {
      const Vec3 foot = projected(solid_, position, 3);
      if ((foot - position).norm() < snap_distance * spacing_) return {foot, 0, Side::on};
    }
    return {position, value, value < 0 ? Side::inside : Side::outside};
  }

  void cut(const std::array<Index, 4>& tetrahedron) {
    Selection inside, on, outside;
    for (const Index i : tetrahedron) {
      const Side side = points_[i].side;
      (side == Side::inside ? inside : side == Side::on ? on : outside).add(i);
    }
    if (inside.size == 0 || on.size + outside.size == 0) return;

    // The corners of the cut are the points on the surface, followed by the intersections with
    // edges.
    Selection corners;
    for (int i = 0; i < on.size; ++i) corners.add(vertex_on(on.item[i]));
    for (int i = 0; i < inside.size; ++i)
      for (int j = 0; j < outside.size; ++j) {
        // The second row is reversed, so that the corners of a quadrilateral are in cyclic order.
        const int column = i == 0 ? j : outside.size - 1 - j;
        corners.add(crossing(inside.item[i], outside.item[column]));
      }
    const Vec3& behind = points_[inside.item[0]].position;
    if (corners.size == 3) add_face(corners.item[0], corners.item[1], corners.item[2], behind);
    if (corners.size == 4) add_quadrilateral(corners.item, behind);
  }

  void add_quadrilateral(const std::array<Index, 4>& corners, const Vec3& behind) {
    const auto length = [&](int i, int j) {
      return (mesh_.positions[corners[i]] - mesh_.positions[corners[j]]).squaredNorm();
    };
    const int shift = length(0, 2) <= length(1, 3) ? 0 : 1;
    const auto corner = [&](int i) { return corners[(i + shift) % 4]; };
    add_face(corner(0), corner(1), corner(2), behind);
    add_face(corner(0), corner(2), corner(3), behind);
  }

  void add_face(Index a, Index b, Index c, const Vec3& behind) {
    const Vec3& origin = mesh_.positions[a];
    const Vec3 normal = (mesh_.positions[b] - origin).cross(mesh_.positions[c] - origin);
    if (normal.dot(origin - behind) < 0) std::swap(b, c);
    mesh_.faces.push_back({a, b, c});
  }

  Index vertex_on(Index i) {
    if (points_[i].vertex == no_index) points_[i].vertex = add_vertex(points_[i].position);
    return points_[i].vertex;
  }

  Index crossing(Index inside, Index outside) {
    const std::uint64_t key = static_cast<std::uint64_t>(inside) << 32 | outside;
    const auto [entry, is_new] =
        vertex_of_edge_.try_emplace(key, static_cast<Index>(mesh_.positions.size()));
    if (is_new) {
      const LatticePoint& low = points_[inside];
      const LatticePoint& high = points_[outside];
      const double share = low.value / (low.value - high.value);
      add_vertex(low.position + share * (high.position - low.position));
    }
    return entry->second;
  }

  Index add_vertex(const Vec3& position) {
    mesh_.positions.push_back(position);
    return static_cast<Index>(mesh_.positions.size() - 1);
  }

  // Removes faces with tetrahedra inside the solid on both sides.
  void remove_membranes() {
    const auto corners_of = [&](Index f) {
      Face face = mesh_.faces[f];
      std::sort(face.begin(), face.end());
      return face;
    };
    std::vector<Index> order(mesh_.faces.size());
    for (std::size_t f = 0; f < order.size(); ++f) order[f] = static_cast<Index>(f);
    std::sort(order.begin(), order.end(),
              [&](Index f, Index g) { return corners_of(f) < corners_of(g); });
    std::vector<bool> is_membrane(order.size(), false);
    for (std::size_t i = 1; i < order.size(); ++i)
      if (corners_of(order[i - 1]) == corners_of(order[i]))
        is_membrane[order[i - 1]] = is_membrane[order[i]] = true;
    std::size_t kept = 0;
    for (std::size_t f = 0; f < order.size(); ++f)
      if (!is_membrane[f]) mesh_.faces[kept++] = mesh_.faces[f];
    mesh_.faces.resize(kept);
  }

  const ImplicitSolid& solid_;
  const double spacing_;
  const Eigen::Matrix3d turn_;
  std::vector<LatticePoint> points_;
  std::unordered_map<std::uint64_t, Index> point_of_site_;   // never iterated over
  std::unordered_map<std::uint64_t, Index> vertex_of_edge_;  // never iterated over
  Mesh mesh_;
};

}  // namespace

Mesh march(const ImplicitSolid& solid, double spacing, unsigned variant) {
  return Marcher(solid, spacing, variant).run();
}

}  // namespace transformesh::shapes
