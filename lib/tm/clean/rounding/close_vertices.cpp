#include "tm/clean/rounding/close_vertices.h"

#include <array>
#include <cmath>
#include <set>
#include <unordered_map>

#include "tm/geometry/predicates.h"

namespace transformesh {
namespace {

// Points in cells of the size of their own spacings, to find those that are close to a position.
class LocalGrid {
 public:
  LocalGrid(double spacings, Scalar coordinate) : spacings_(spacings), coordinate_(coordinate) {}

  double reach(const Vec3& position) const {
    return spacings_ * spacing_around(position, coordinate_);
  }
  void add(const Vec3& position, Index point);
  /// Calls visit(point) for all points that are within reach of the position, and some others.
  template <class Visit>
  void visit_near(const Vec3& position, const Visit& visit) const;

 private:
  using Cell = std::array<double, 3>;  ///< whole numbers, beyond the range of integers too
  struct Key {
    int exponent;
    Cell cell;
    bool operator==(const Key& other) const = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::size_t hash = static_cast<std::size_t>(key.exponent);
      for (const double x : key.cell) hash = hash * 0x9e3779b97f4a7c15U ^ std::hash<double>()(x);
      return hash;
    }
  };

  // Cells are wider than the reach, so that most positions have few cells within reach.
  static double cell_at(double x, int exponent) {
    return std::floor(std::ldexp(x, -exponent - 3)) + 0.0;
  }
  int exponent_at(const Vec3& position) const { return std::ilogb(reach(position)); }

  double spacings_;
  Scalar coordinate_;
  std::set<int> exponents_;
  std::unordered_map<Key, std::vector<Index>, Hash> cells_;
};

void LocalGrid::add(const Vec3& position, Index point) {
  const int exponent = exponent_at(position);
  exponents_.insert(exponent);
  Key key{exponent, {}};
  for (int i = 0; i < 3; ++i)
    key.cell[static_cast<std::size_t>(i)] = cell_at(position[i], exponent);
  cells_[key].push_back(point);
}

template <class Visit>
void LocalGrid::visit_near(const Vec3& position, const Visit& visit) const {
  const double distance = reach(position);
  const int middle = exponent_at(position);
  for (int exponent = middle - 1; exponent <= middle + 1; ++exponent) {
    if (!exponents_.contains(exponent)) continue;
    std::array<std::array<double, 2>, 3> range;
    for (int i = 0; i < 3; ++i)
      range[static_cast<std::size_t>(i)] = {cell_at(position[i] - distance, exponent),
                                            cell_at(position[i] + distance, exponent)};
    const auto& [x, y, z] = range;
    for (double i = x[0]; i <= x[1]; ++i)
      for (double k = y[0]; k <= y[1]; ++k)
        for (double l = z[0]; l <= z[1]; ++l) {
          const auto found = cells_.find(Key{exponent, {i, k, l}});
          if (found == cells_.end()) continue;
          for (const Index point : found->second) visit(point);
        }
  }
}

// The position that attracts one: the nearest within reach; no_index where there is none.
Index attractor(const LocalGrid& grid, const std::vector<Vec3>& positions, const Vec3& position) {
  Index best = no_index;
  double least = grid.reach(position);
  grid.visit_near(position, [&](Index other) {
    const double distance = (positions[other] - position).lpNorm<Eigen::Infinity>();
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

CornerPositions::CornerPositions(const Mesh& mesh, const std::vector<Index>& faces) {
  for (const Index face : faces)
    for (const Index v : mesh.faces[face]) positions_.push_back(mesh.positions[v]);
  std::sort(positions_.begin(), positions_.end(), is_before);
  positions_.erase(std::unique(positions_.begin(), positions_.end()), positions_.end());
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
                                  const MoveRule& rule, Scalar coordinate) {
  const CornerPositions corners(assembly.mesh, faces);
  const std::vector<char> is_input = find_input_positions(assembly, corners);
  const std::vector<Vec3>& positions = corners.positions();
  std::vector<Vec3> moved = positions;
  Displacement displacement;
  LocalGrid grid(rule.spacings, coordinate);
  for (const bool turn : {true, false}) {
    for (Index i = 0; i < positions.size(); ++i) {
      if ((is_input[i] != 0) != turn) continue;
      const bool stays = turn && !rule.moves_input;
      const Index to = stays ? no_index : attractor(grid, positions, positions[i]);
      if (to == no_index) {
        grid.add(positions[i], i);
        continue;
      }
      moved[i] = positions[to];
      displacement.note((moved[i] - positions[i]).stableNorm(),
                        spacing_around(positions[i], coordinate));
    }
  }
  if (displacement.length > 0) corners.move(assembly, moved);
  return displacement;
}

}  // namespace transformesh
