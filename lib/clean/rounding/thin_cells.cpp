#include "clean/rounding/thin_cells.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "clean/exterior/patches.h"
#include "clean/rounding/triangle_distance.h"

namespace transformesh {
namespace {

/// Label of a cell that is not known to be outside (label 0) or inside (label 1).
constexpr char unknown = 2;

/// Error of the computed distance of a point from the plane of a triangle, relative to the distance
/// of the point from a corner of the triangle.
constexpr double measuring_error = std::numeric_limits<double>::epsilon() / 2;

/// The cells into which an arrangement divides space, each labeled as inside or outside. A cell is
/// bounded by sides of patches: side 2 * patch is in front of a patch, side 2 * patch + 1 behind
/// it. The index of a cell is the index of one of its sides.
class LabeledCells {
 public:
  LabeledCells(Arrangement& arrangement, const std::vector<char>& kept, const Thinness& thinness);
  bool give_thin_ones_away(Displacement& moved);
  void keep_boundary(std::vector<char>& kept) const;

 private:
  struct Plane {
    Triangle triangle;
    Vec3 normal = Vec3::Zero();
  };

  void spread_labels(const std::vector<char>& kept);
  void measure_patches();
  Plane largest_plane(Index cell) const;
  double most_spacings(Index cell) const;
  bool is_thin(Index cell, Displacement& thickness) const;
  bool wants_change(Index cell) const;
  template <class Visit>
  void visit_corners(Index cell, const Visit& visit) const;

  Arrangement& arrangement_;
  const Thinness& thinness_;
  Patches patches_;
  std::vector<Index> cell_of_;             ///< for each side of each patch, the cell that it bounds
  std::vector<std::vector<Index>> sides_;  ///< for each cell, the sides of patches on its boundary
  std::vector<char> is_inside_;            ///< label of each cell: 0, 1 or `unknown`
  std::vector<Vec3> positions_;            ///< position of each point
  /// Twice the area of each patch, relative to the squared size of the mesh.
  std::vector<double> areas_;
  std::vector<Index> largest_;  ///< index of the largest triangle in each patch
};

LabeledCells::LabeledCells(Arrangement& arrangement, const std::vector<char>& kept,
                           const Thinness& thinness)
    : arrangement_(arrangement), thinness_(thinness), patches_(arrangement) {
  DisjointSets sides = join_sides_around_edges(arrangement, patches_);
  const auto count = static_cast<Index>(2 * patches_.size());
  sides_.resize(count);
  for (Index side = 0; side < count; ++side) {
    cell_of_.push_back(sides.find(side));
    sides_[cell_of_[side]].push_back(side);
  }
  for (Index i = 0; i < arrangement.point_count(); ++i)
    positions_.push_back(arrangement.position(i));
  spread_labels(kept);
  measure_patches();
}

// Labels all cells. A patch in `kept` has an outside cell in front and an inside cell behind. The
// two cells at any other patch have the same label.
void LabeledCells::spread_labels(const std::vector<char>& kept) {
  is_inside_.assign(cell_of_.size(), unknown);
  std::vector<Index> queue;
  const auto label = [&](Index cell, char value) {
    if (is_inside_[cell] != unknown) return;
    is_inside_[cell] = value;
    queue.push_back(cell);
  };
  const auto is_kept = [&](Index side) { return kept[patches_.pieces[side / 2].front()] != 0; };
  for (Index side = 0; side < cell_of_.size(); ++side)
    if (is_kept(side)) label(cell_of_[side], static_cast<char>(side % 2));
  for (std::size_t i = 0; i < queue.size(); ++i)  // NOLINT: label() adds to queue
    for (const Index side : sides_[queue[i]])
      if (!is_kept(side)) label(cell_of_[side ^ 1U], is_inside_[queue[i]]);
}

void LabeledCells::measure_patches() {
  double size = 0;
  for (const Vec3& p : positions_) size = std::max(size, (p - positions_[0]).cwiseAbs().maxCoeff());
  for (Index patch = 0; patch < patches_.size(); ++patch) {
    double sum = 0, most = -1;
    largest_.push_back(no_index);
    for (const Index piece : patches_.pieces[patch]) {
      const Triangle t = triangle_of(positions_, arrangement_.pieces[piece].corners);
      const double area = ((t[1] - t[0]) / size).cross((t[2] - t[0]) / size).stableNorm();
      sum += area;
      if (area <= most) continue;
      most = area;
      largest_.back() = piece;
    }
    areas_.push_back(sum);
  }
}

// Returns the plane of the largest triangle in the largest patch on the boundary of the cell.
LabeledCells::Plane LabeledCells::largest_plane(Index cell) const {
  Index largest = sides_[cell].front() / 2;
  for (const Index side : sides_[cell])
    if (areas_[side / 2] > areas_[largest]) largest = side / 2;
  const Triangle t = triangle_of(positions_, arrangement_.pieces[largest_[largest]].corners);
  return {t, unit_normal(t)};
}

// Calls visit(position) for all corners of triangles on the boundary of the cell, until `visit`
// returns false.
template <class Visit>
void LabeledCells::visit_corners(Index cell, const Visit& visit) const {
  for (const Index side : sides_[cell])
    for (const Index piece : patches_.pieces[side / 2])
      for (const Index corner : arrangement_.pieces[piece].corners)
        if (!visit(positions_[corner])) return;
}

// Returns the largest thickness of a thin cell, in spacings of floating-point numbers. The coarsest
// grid among the faces on the boundary of the cell determines this limit.
double LabeledCells::most_spacings(Index cell) const {
  int level = 0;
  for (const Index side : sides_[cell])
    for (const Index piece : patches_.pieces[side / 2])
      for (const PieceSource& source : arrangement_.sources_of(arrangement_.pieces[piece]))
        level = std::max<int>(level, thinness_.levels[arrangement_.welded->face_of[source.face]]);
  return std::ldexp(thinness_.steps, level - 1);
}

// True if the cell is thin: all its corners are between two parallel planes, and the distance of
// the planes is below most_spacings() at each corner.
bool LabeledCells::is_thin(Index cell, Displacement& thickness) const {
  const Plane plane = largest_plane(cell);
  if (plane.normal.isZero(0)) return false;
  const double spacings = most_spacings(cell);
  double low = 0, high = 0;
  bool is_thin = true;
  const auto check = [&](const Vec3& p) {
    const double height = height_over(plane.triangle, plane.normal, p);
    low = std::min(low, height);
    high = std::max(high, height);
    const double error = measuring_error * (p - plane.triangle[0]).stableNorm();
    is_thin = std::max(high - height, height - low) + error <=
              spacings * spacing_around(p, thinness_.type);
    return is_thin;
  };
  visit_corners(cell, check);
  if (is_thin) visit_corners(cell, check);  // test again: `low` and `high` are final now
  if (is_thin) thickness.note(high - low, spacing_around(plane.triangle[0], thinness_.type));
  return is_thin;
}

// True if the surface becomes smaller when the label of the cell changes from inside to outside, or
// from outside to inside.
bool LabeledCells::wants_change(Index cell) const {
  double alike = 0, unlike = 0;
  for (const Index side : sides_[cell]) {
    const Index beyond = cell_of_[side ^ 1U];
    if (beyond == cell) continue;
    (is_inside_[beyond] == is_inside_[cell] ? alike : unlike) += areas_[side / 2];
  }
  return unlike > alike;
}

bool LabeledCells::give_thin_ones_away(Displacement& moved) {
  std::vector<Index> thin;
  Displacement thickness;
  for (Index cell = 0; cell < sides_.size(); ++cell) {
    if (sides_[cell].empty() || is_inside_[cell] == unknown) continue;
    if (is_thin(cell, thickness)) thin.push_back(cell);
  }
  bool is_any = false, is_changed = true;
  // Each change of a label reduces the area of the surface, so the loop ends. Because areas have
  // rounding errors, the number of turns is limited, too.
  for (std::size_t turn = 0; turn < thin.size() && is_changed; ++turn) {
    is_changed = false;
    for (const Index cell : thin) {
      if (!wants_change(cell)) continue;
      is_inside_[cell] = is_inside_[cell] ? 0 : 1;
      is_changed = is_any = true;
    }
  }
  if (is_any) moved += thickness;
  return is_any;
}

void LabeledCells::keep_boundary(std::vector<char>& kept) const {
  std::vector<char> of_side;
  of_side.reserve(cell_of_.size());
  for (const Index cell : cell_of_) of_side.push_back(is_inside_[cell]);
  transformesh::keep_boundary(arrangement_, patches_, of_side, kept);
}

}  // namespace

bool give_thin_cells_away(Arrangement& arrangement, std::vector<char>& kept,
                          const Thinness& thinness, Displacement& moved) {
  LabeledCells cells(arrangement, kept, thinness);
  const bool is_any = cells.give_thin_ones_away(moved);
  if (is_any) cells.keep_boundary(kept);
  return is_any;
}

}  // namespace transformesh
