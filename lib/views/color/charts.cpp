#include "views/color/charts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <numeric>

#include "mesh/edges.h"
#include "support/elementary/trigonometric.h"
#include "transformesh/image.h"
#include "transformesh/measure.h"
#include "views/color/texels.h"

namespace transformesh {
namespace {

/// Least cosine of the angle between the normal of a face and the mean normal of its chart.
/// `least_cosine` applies when faces of charts with at most `few_faces` faces are moved to larger
/// charts; `usual_cosine` applies otherwise. Larger values of the cosines distort less but make
/// more charts.
constexpr double usual_cosine = 0.5;
constexpr double least_cosine = 0.2;
constexpr std::size_t few_faces = 12;
/// Number of rotations of a chart, between 0 and 90 degrees, that are tried.
constexpr int turns = 12;

using Corners = std::array<Eigen::Vector2d, 3>;

class ChartGrower {
 public:
  explicit ChartGrower(const Mesh& mesh)
      : label_(mesh.faces.size(), no_index), normal_(mesh.faces.size()) {
    const Edges edges(mesh);
    across_ = neighbors_across(edges, mesh.faces.size());
    for (std::size_t f = 0; f < normal_.size(); ++f)
      normal_[f] = face_normal(mesh, static_cast<Index>(f));
  }

  /// Divides `faces` into charts. A chart lists its faces in the order in which they were added.
  std::vector<std::vector<Index>> grow(const std::vector<Index>& faces) {
    charts_.clear();
    axis_.clear();
    for (const Index face : faces) label_[face] = no_index, is_open_.resize(label_.size(), 0);
    for (const Index face : faces) is_open_[face] = 1;
    for (const Index face : faces)
      if (label_[face] == no_index) grow_from(face);
    merge_few();
    for (const Index face : faces) is_open_[face] = 0;
    return std::move(charts_);
  }

  Vec3 axis(const std::vector<Index>& chart) const {
    Vec3 sum = Vec3::Zero();
    for (const Index face : chart) sum += normal_[face];
    return sum.isZero() ? Vec3(Vec3::UnitZ()) : Vec3(sum.stableNormalized());
  }

 private:
  bool fits(Index face, const Vec3& axis, double cosine) const {
    return normal_[face].dot(axis) >= cosine * normal_[face].norm() * axis.norm();
  }

  template <class Action>
  void for_neighbors(Index face, const Action& action) const {
    for (Index i = 0; i < 3; ++i) {
      const Index other = across_[3 * face + i];
      if (other != no_index && is_open_[other / 3]) action(other / 3);
    }
  }

  void grow_from(Index seed) {
    const auto label = static_cast<Index>(charts_.size());
    std::vector<Index>& chart = charts_.emplace_back();
    Vec3 axis = Vec3::Zero();
    std::deque<Index> queue{seed};
    while (!queue.empty()) {
      const Index face = queue.front();
      queue.pop_front();
      if (label_[face] != no_index || !fits(face, axis, usual_cosine)) continue;
      label_[face] = label;
      chart.push_back(face);
      axis += normal_[face];
      for_neighbors(face, [&](Index other) {
        if (label_[other] == no_index) queue.push_back(other);
      });
    }
    axis_.push_back(axis);
  }

  /// Moves each face of a chart of at most `few_faces` faces to the adjacent chart whose mean
  /// normal fits best, if any.
  void merge_few() {
    for (std::size_t c = 0; c < charts_.size(); ++c) {
      if (charts_[c].size() > few_faces) continue;
      std::erase_if(charts_[c], [&](Index face) {
        const Index to = best_neighbor(face);
        if (to == no_index) return false;
        label_[face] = to;
        charts_[to].push_back(face);
        return true;
      });
    }
    std::erase_if(charts_, [](const std::vector<Index>& chart) { return chart.empty(); });
  }

  Index best_neighbor(Index face) const {
    Index best = no_index;
    double most = least_cosine * normal_[face].norm();
    for_neighbors(face, [&](Index other) {
      const Index label = label_[other];
      if (charts_[label].size() <= few_faces) return;
      const double projected = normal_[face].dot(axis_[label].stableNormalized());
      if (projected >= most && label != label_[face]) most = projected, best = label;
    });
    return best;
  }

  std::vector<Index> label_;
  std::vector<Vec3> normal_;
  std::vector<Index> across_;
  std::vector<char> is_open_;
  std::vector<std::vector<Index>> charts_;
  std::vector<Vec3> axis_;
};

Eigen::AlignedBox2d extent_of(const std::vector<Corners>& faces) {
  Eigen::AlignedBox2d extent;
  for (const Corners& corners : faces)
    for (const Eigen::Vector2d& corner : corners) extent.extend(corner);
  return extent;
}

std::vector<Corners> turned(std::vector<Corners> faces, double angle) {
  Eigen::Matrix2d turn;
  turn << elementary::cos(angle), -elementary::sin(angle), elementary::sin(angle),
      elementary::cos(angle);
  for (Corners& corners : faces)
    for (Eigen::Vector2d& corner : corners) corner = turn * corner;
  return faces;
}

/// Returns the faces of a chart, rotated such that their bounding box has the smallest area of all
/// tried rotations and is wider than high.
std::vector<Corners> well_turned(const std::vector<Corners>& faces) {
  std::vector<Corners> best = faces;
  double least = HUGE_VAL;
  for (int i = 0; i < turns; ++i) {
    std::vector<Corners> next = turned(faces, i * std::numbers::pi / 2 / turns);
    const double area = extent_of(next).sizes().prod();
    if (area < least) least = area, best = std::move(next);
  }
  const Eigen::Vector2d size = extent_of(best).sizes();
  return size.x() < size.y() ? turned(best, std::numbers::pi / 2) : best;
}

Chart flattened(const Mesh& mesh, std::vector<Index> faces, const Vec3& axis) {
  const Vec3 right = axis.unitOrthogonal();
  const Vec3 up = axis.cross(right);
  Chart chart{std::move(faces), {}, {}};
  const Vec3 origin = mesh.positions[mesh.faces[chart.faces.front()][0]];
  for (const Index face : chart.faces) {
    Corners& corners = chart.corners.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 offset = mesh.positions[mesh.faces[face][i]] - origin;
      corners[i] = {right.dot(offset), up.dot(offset)};
    }
  }
  chart.corners = well_turned(chart.corners);
  const Eigen::AlignedBox2d extent = extent_of(chart.corners);
  for (Corners& corners : chart.corners)
    for (Eigen::Vector2d& corner : corners) corner -= extent.min();
  chart.size = extent.sizes();
  return chart;
}

/// Finds faces of the chart that overlap earlier faces in the plane: both cover the same texel.
/// Removes the later faces from the chart and returns them.
std::vector<Index> take_overlaps(Chart& chart, double texel) {
  std::vector<char> is_over(chart.faces.size(), 0);
  const auto width = static_cast<int>(chart.size.x() / texel) + 1;
  const auto height = static_cast<int>(chart.size.y() / texel) + 1;
  Raster<char> is_taken(width, height, 0);
  for (std::size_t i = 0; i < chart.faces.size(); ++i) {
    Corners corners = chart.corners[i];
    for (Eigen::Vector2d& corner : corners) corner /= texel;
    const auto for_inner = [&](const auto& action) {
      for_texels(corners, 1e-6, width, height, [&](int x, int y, const auto&) { action(x, y); });
    };
    for_inner([&](int x, int y) { is_over[i] |= is_taken.at(x, y); });
    if (!is_over[i]) for_inner([&](int x, int y) { is_taken.at(x, y) = 1; });
  }
  std::vector<Index> over;
  Chart rest{{}, {}, chart.size};
  for (std::size_t i = 0; i < chart.faces.size(); ++i) {
    if (is_over[i]) {
      over.push_back(chart.faces[i]);
    } else {
      rest.faces.push_back(chart.faces[i]);
      rest.corners.push_back(chart.corners[i]);
    }
  }
  chart = std::move(rest);
  return over;
}

}  // namespace

std::vector<Chart> make_charts(const Mesh& mesh, double texel) {
  ChartGrower grower(mesh);
  std::vector<Index> left(mesh.faces.size());
  std::iota(left.begin(), left.end(), Index{0});
  std::vector<Chart> charts;
  // The first face of each chart is never removed by take_overlaps(), so that fewer faces are left
  // in each round.
  while (!left.empty()) {
    std::vector<Index> over;
    for (std::vector<Index>& faces : grower.grow(left)) {
      const Vec3 axis = grower.axis(faces);
      Chart& chart = charts.emplace_back(flattened(mesh, std::move(faces), axis));
      const std::vector<Index> more = take_overlaps(chart, texel);
      over.insert(over.end(), more.begin(), more.end());
    }
    std::sort(over.begin(), over.end());
    left = std::move(over);
  }
  return charts;
}

}  // namespace transformesh
