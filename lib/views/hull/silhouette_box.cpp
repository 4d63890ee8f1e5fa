/// Computes a box that contains the visual hull. Each coordinate of the box is the result of a
/// linear program in three variables, which CGAL solves exactly. There is one constraint per
/// camera, and one per side of a silhouette's bounding rectangle.
#include <CGAL/Gmpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "raster/camera.h"
#include "transformesh/errors.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/hull/contour_distance.h"
#include "views/hull/hull_values.h"

namespace transformesh {
namespace {

/// The set of points X with row * (X, 1) <= 0.
using HalfSpace = Eigen::RowVector4d;
using LinearProgram = CGAL::Quadratic_program<double>;
using Solution = CGAL::Quadratic_program_solution<CGAL::Gmpzf>;

/// First and last column (or row) that contains a pixel inside the silhouette; empty if `last` <
/// `first`.
struct Range {
  int first = 0;
  int last = -1;

  void add(int place) {
    if (last < first) first = place;
    first = std::min(first, place);
    last = std::max(last, place);
  }
};

struct Rectangle {
  Range columns, rows;
};

Rectangle bounding_rectangle(const View& view) {
  Rectangle rectangle;
  for (int y = 0; y < view.silhouette.height; ++y) {
    for (int x = 0; x < view.silhouette.width; ++x) {
      if (view.silhouette.at(x, y) <= contour_intensity) continue;
      rectangle.columns.add(x);
      rectangle.rows.add(y);
    }
  }
  if (rectangle.columns.last < 0)
    throw InputError("the silhouette of '" + view.name + "' is empty: no pixel is inside");
  return rectangle;
}

void add_bounds(const HalfSpace& pixel_row, const HalfSpace& depth_row, const Range& range,
                int size, std::vector<HalfSpace>& bounds) {
  if (range.first > 0) bounds.emplace_back((range.first - 1) * depth_row - pixel_row);
  if (range.last < size - 1) bounds.emplace_back(pixel_row - (range.last + 1) * depth_row);
}

std::vector<HalfSpace> half_spaces(std::span<const View> views) {
  std::vector<HalfSpace> bounds;
  for (const View& view : views) {
    const Projection projection = view.camera.projection();
    bounds.emplace_back(-projection.row(2));
    if (view.silhouette.empty()) continue;
    const Rectangle rectangle = bounding_rectangle(view);
    add_bounds(projection.row(0), projection.row(2), rectangle.columns, view.silhouette.width,
               bounds);
    add_bounds(projection.row(1), projection.row(2), rectangle.rows, view.silhouette.height,
               bounds);
  }
  return bounds;
}

LinearProgram program_of(const std::vector<HalfSpace>& bounds) {
  LinearProgram program(CGAL::SMALLER, false, 0, false, 0);
  for (int row = 0; row < static_cast<int>(bounds.size()); ++row) {
    const HalfSpace& bound = bounds[static_cast<std::size_t>(row)];
    for (int axis = 0; axis < 3; ++axis) program.set_a(axis, row, bound[axis]);
    program.set_b(row, -bound[3]);
  }
  return program;
}

/// Returns the minimum of the coordinate along `axis` if `sign` is 1, the maximum if `sign` is -1.
double least(LinearProgram program, int axis, double sign) {
  program.set_c(axis, sign);
  const Solution solution = CGAL::solve_linear_program(program, CGAL::Gmpzf());
  if (solution.is_infeasible())
    throw InputError(
        "no point lies in all silhouettes: check that the cameras belong to these images");
  if (solution.is_unbounded())
    throw InputError("the silhouettes do not bound the object on all sides: give its box");
  return sign * CGAL::to_double(solution.objective_value());
}

}  // namespace

Box silhouette_box(std::span<const View> views) {
  const LinearProgram program = program_of(half_spaces(views));
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min()[axis] = least(program, axis, 1);
    box.max()[axis] = least(program, axis, -1);
  }
  return box;
}

}  // namespace transformesh
