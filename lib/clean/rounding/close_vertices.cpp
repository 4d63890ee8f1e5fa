#include "clean/rounding/close_vertices.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

#include "clean/rounding/local_distance.h"
#include "geometry/numbers/predicates.h"

namespace transformesh {
namespace {

// Points in cells of the size of their own spacings, to find those that are close to a position.
// Points with the same spacings are a group.
class LocalGrid {
 public:
  explicit LocalGrid(double spacings) : spacings_(spacings) {}

  void add(const Vec3& position, const Vec3& spacing, Index point);
  /// Calls visit(point) for all points within that many spacings of the position, and some others.
  template <class Visit>
  void visit_near(const Vec3& position, const Vec3& spacing, const Visit& visit) const;

 private:
  using Cell = std::array<double, 3>;  ///< whole numbers, beyond the range of integers too
  struct Hash {
    std::size_t operator()(const Cell& cell) const {
      std::size_t hash = 0;
      for (const double x : cell) hash = hash * 0x9e3779b97f4a7c15U ^ std::hash<double>()(x);
      return hash;
    }
  };
  struct Group {
    Eigen::AlignedBox3d box;
    std::vector<Index> points;
    std::unordered_map<Cell, std::vector<Index>, Hash> cells;
  };

  template <class Visit>
  static void visit_cells(const Group& group, const Cell& first, const Cell& last,
                          const Visit& visit);

  // Cells are wider than the reach, so that most positions have few cells within reach.
  Cell cell_at(const Vec3& position, const Vec3& spacing) const {
    const Vec3 cell = (position.array() / (16 * spacings_ * spacing.array())).floor() + 0.0;
    return {cell.x(), cell.y(), cell.z()};
  }

  double spacings_;
  std::map<Cell, Group> groups_;  ///< by their spacings
};

void LocalGrid::add(const Vec3& position, const Vec3& spacing, Index point) {
  Group& group = groups_[{spacing.x(), spacing.y(), spacing.z()}];
  group.box.extend(position);
  group.points.push_back(point);
  group.cells[cell_at(position, spacing)].push_back(point);
}

template <class Visit>
void LocalGrid::visit_near(const Vec3& position, const Vec3& spacing, const Visit& visit) const {
  const Vec3 low = position - spacings_ * spacing, high = position + spacings_ * spacing;
  for (const auto& [key, group] : groups_) {
    if (!group.box.intersects(Eigen::AlignedBox3d(low, high))) continue;
    const Vec3 of_group(key[0], key[1], key[2]);
    const Cell first = cell_at(low, of_group), last = cell_at(high, of_group);
    double cells = 1;
    for (std::size_t i = 0; i < 3; ++i) cells *= last[i] - first[i] + 1;
    if (cells <= static_cast<double>(group.points.size())) {
      visit_cells(group, first, last, visit);
    } else {
      std::for_each(group.points.begin(), group.points.end(), visit);
    }
  }
}

template <class Visit>
void LocalGrid::visit_cells(const Group& group, const Cell& first, const Cell& last,
                            const Visit& visit) {
  const auto count = [&](std::size_t axis) {
    return static_cast<std::size_t>(last[axis] - first[axis] + 1);
  };
  const auto at = [&](std::size_t axis, std::size_t i) {
    return first[axis] + static_cast<double>(i);
  };
  for (std::size_t i = 0; i < count(0); ++i)
    for (std::size_t k = 0; k < count(1); ++k)
      for (std::size_t l = 0; l < count(2); ++l) {
        const auto found = group.cells.find(Cell{at(0, i), at(1, k), at(2, l)});
        if (found == group.cells.end()) continue;
        std::for_each(found->second.begin(), found->second.end(), visit);
      }
}

// The position that attracts one: the nearest within reach; no_index where there is none.
Index attractor(const LocalGrid& grid, const std::vector<Vec3>& positions, const Vec3& position,
                const Vec3& spacing, double spacings) {
  Index best = no_index;
  double least = spacings;
  grid.visit_near(position, spacing, [&](Index other) {
    const double distance =
        (positions[other] - position).cwiseQuotient(spacing).lpNorm<Eigen::Infinity>();
    const bool is_better = distance < least || (distance == least && other < best);
    if (!is_better) return;
    least = distance;
    best = other;
  });
  return best;
}

// Marks the positions at which an input vertex is.
std::vector<char> find_input_positions(const Assembly& assembly, const CornerPositions& corners) {
  std::vector<char> is_input(corners.positions().size(), 0);
  for (Index v = 0; v < assembly.mesh.positions.size(); ++v) {
    if (assembly.vertex_is_new[v]) continue;
    const Index found = corners.find(assembly.mesh.positions[v]);
    if (found != no_index) is_input[found] = 1;
  }
  return is_input;
}

bool is_before(const Vec3& a, const Vec3& b) { return compare_positions(a, b) < 0; }

}  // namespace

CornerPositions::CornerPositions(const Mesh& mesh, const std::vector<Index>& faces)
    : number_of_(mesh.positions.size(), no_index) {
  std::vector<Index> vertices;
  for (const Index face : faces)
    for (const Index v : mesh.faces[face]) {
      if (number_of_[v] == no_index) vertices.push_back(v);
      number_of_[v] = 0;
    }
  std::sort(vertices.begin(), vertices.end(), [&](Index a, Index b) {
    const int order = compare_positions(mesh.positions[a], mesh.positions[b]);
    return order != 0 ? order < 0 : a < b;
  });
  for (const Index v : vertices) {
    if (positions_.empty() || positions_.back() != mesh.positions[v])
      positions_.push_back(mesh.positions[v]);
    number_of_[v] = static_cast<Index>(positions_.size() - 1);
  }
}

std::vector<Vec3> CornerPositions::spacings(const Mesh& mesh, const std::vector<Index>& faces,
                                            const Spacings& spacing) const {
  std::vector<Vec3> result(positions_.size(), Vec3::Zero());
  for (const Index face : faces) {
    const Triangle t = triangle_of(mesh, face);
    const Vec3 extent = t[0].cwiseMax(t[1]).cwiseMax(t[2]) - t[0].cwiseMin(t[1]).cwiseMin(t[2]);
    for (const Index v : mesh.faces[face]) {
      Vec3& most = result[number_of_[v]];
      most = most.cwiseMax(spacing.on_face(extent, mesh.positions[v]));
    }
  }
  return result;
}

Index CornerPositions::find(const Vec3& position) const {
  const auto found = std::lower_bound(positions_.begin(), positions_.end(), position, is_before);
  if (found == positions_.end() || *found != position) return no_index;
  return static_cast<Index>(found - positions_.begin());
}

void CornerPositions::move(Assembly& assembly, const std::vector<Vec3>& to) const {
  Mesh& mesh = assembly.mesh;
  std::vector<char> is_moved(mesh.positions.size(), 0);
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    const Index found = find(mesh.positions[v]);
    if (found == no_index || to[found] == mesh.positions[v]) continue;
    mesh.positions[v] = to[found];
    is_moved[v] = assembly.vertex_is_new[v] = 1;
  }
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    if (is_moved[a] || is_moved[b] || is_moved[c]) assembly.face_is_new[f] = 1;
  }
}

Displacement merge_close_vertices(Assembly& assembly, const std::vector<Index>& faces,
                                  const MoveRule& rule, const Spacings& spacing) {
  const CornerPositions corners(assembly.mesh, faces);
  const std::vector<char> is_input = find_input_positions(assembly, corners);
  const std::vector<Vec3>& positions = corners.positions();
  const std::vector<Vec3> spacings = corners.spacings(assembly.mesh, faces, spacing);
  std::vector<Vec3> moved = positions;
  Displacement displacement;
  LocalGrid grid(rule.spacings);
  for (const bool turn : {true, false}) {
    for (Index i = 0; i < positions.size(); ++i) {
      if ((is_input[i] != 0) != turn) continue;
      const bool stays = turn && !rule.moves_input;
      const Index to =
          stays ? no_index : attractor(grid, positions, positions[i], spacings[i], rule.spacings);
      if (to == no_index) {
        grid.add(positions[i], spacings[i], i);
        continue;
      }
      moved[i] = positions[to];
      displacement.note((moved[i] - positions[i]).stableNorm(),
                        spacing_around(positions[i], spacing.type));
    }
  }
  if (displacement.length > 0) corners.move(assembly, moved);
  return displacement;
}

}  // namespace transformesh
