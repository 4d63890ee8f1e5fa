#include "shapes/boxes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "shapes/assembly.h"
#include "support/elementary/exponential.h"
#include "support/random.h"

namespace transformesh::shapes {
namespace {

/// Builds the surface of a box as a grid of rectangular cells on each side. Points are numbered in
/// the order of their first use.
class BoxBuilder {
 public:
  BoxBuilder(Vec3 edges, const std::array<std::size_t, 3>& cells)
      : edges_(std::move(edges)), cells_(cells) {}

  Mesh build() {
    for (int axis = 0; axis < 3; ++axis)
      for (const bool is_high : {false, true}) add_side(axis, is_high);
    return std::move(mesh_);
  }

 private:
  using Point = std::array<std::size_t, 3>;

  void add_side(int axis, bool is_high) {
    const int first = (axis + 1) % 3;
    const int second = (axis + 2) % 3;
    for (std::size_t i = 0; i < cells_[first]; ++i)
      for (std::size_t j = 0; j < cells_[second]; ++j) {
        const auto corner = [&](std::size_t di, std::size_t dj) {
          Point point;
          point[axis] = is_high ? cells_[axis] : 0;
          point[first] = i + di;
          point[second] = j + dj;
          return vertex(point);
        };
        std::array<Index, 4> square = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
        if (!is_high) std::swap(square[1], square[3]);
        add_square(square, (i + j) % 2 == 0);
      }
  }

  void add_square(const std::array<Index, 4>& corners, bool cut_at_first) {
    const auto [a, b, c, d] = corners;
    if (cut_at_first) {
      mesh_.faces.insert(mesh_.faces.end(), {{a, b, c}, {a, c, d}});
    } else {
      mesh_.faces.insert(mesh_.faces.end(), {{b, c, d}, {b, d, a}});
    }
  }

  Index vertex(const Point& point) {
    const auto [entry, is_new] =
        numbers_.try_emplace(point, static_cast<Index>(mesh_.positions.size()));
    if (is_new) {
      Vec3 share;
      for (int axis = 0; axis < 3; ++axis)
        share[axis] = static_cast<double>(point[axis]) / static_cast<double>(cells_[axis]) - 0.5;
      mesh_.positions.emplace_back(share.cwiseProduct(edges_));
    }
    return entry->second;
  }

  Vec3 edges_;
  Point cells_;
  std::map<Point, Index> numbers_;
  Mesh mesh_;
};

/// Returns the number of cells of this size along each edge, at least one.
std::array<std::size_t, 3> cells_of(const Vec3& edges, double cell) {
  constexpr double most = 1e9;  // cells along an edge, so that the conversion does not overflow
  std::array<std::size_t, 3> cells;
  for (int axis = 0; axis < 3; ++axis)
    cells[axis] = static_cast<std::size_t>(std::clamp(std::round(edges[axis] / cell), 1.0, most));
  return cells;
}

double count_faces(const std::array<std::size_t, 3>& cells) {
  const Vec3 n(static_cast<double>(cells[0]), static_cast<double>(cells[1]),
               static_cast<double>(cells[2]));
  return 4 * (n[0] * n[1] + n[1] * n[2] + n[2] * n[0]);
}

void append_lattice_box(Mesh& mesh, const std::array<long, 3>& low,
                        const std::array<long, 3>& size) {
  Mesh part = BoxBuilder(Vec3::Ones(), {1, 1, 1}).build();
  for (Vec3& point : part.positions)
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = static_cast<double>(low[axis] + (point[axis] > 0 ? size[axis] : 0));
  append(mesh, part);
}

}  // namespace

Mesh box(const Vec3& edges, std::size_t faces) {
  // The number of faces is a step function of the cell size that decreases to 12. Bisection finds
  // the step next to the wanted number.
  const auto wanted = static_cast<double>(faces);
  double small = 0;
  double large = edges.maxCoeff();
  for (int halving = 0; halving < 60; ++halving) {
    const double cell = (small + large) / 2;
    (count_faces(cells_of(edges, cell)) > wanted ? small : large) = cell;
  }
  const auto more = cells_of(edges, small);
  const auto less = cells_of(edges, large);
  const bool is_more_closer = count_faces(more) / wanted < wanted / count_faces(less);
  return BoxBuilder(edges, is_more_closer ? more : less).build();
}

Mesh boxes(std::size_t count, std::uint64_t seed) {
  constexpr long longest = 4;  // edge of a box in cells; chosen by hand
  const long world = longest + std::lround(2 * elementary::cbrt(static_cast<double>(count)));
  Random random(seed);
  Mesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<long, 3> low;
    std::array<long, 3> size;
    for (int axis = 0; axis < 3; ++axis) {
      size[axis] = random.integer(1, longest);
      low[axis] = random.integer(0, world - size[axis]);
    }
    append_lattice_box(mesh, low, size);
  }
  return mesh;
}

}  // namespace transformesh::shapes
