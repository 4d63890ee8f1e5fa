#include "boolean/nested_cells.h"

#include <optional>

#include "geometry/solid_angle_winding.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// A region of space that is bounded by a connected set of patches (parts of the surface between
/// intersection curves). Other sets of patches are ignored.
struct PatchCell {
  Index side = no_index;  ///< one side of a patch; represents the cell in `sides_`
  /// One side of a patch; represents the connected set of patches in `sets_`.
  Index set = no_index;
  /// Six times the signed volume of the cell; negative if the cell is unbounded.
  double volume = 0;
  Mesh surface{};  ///< faces of all patches on the boundary; the cell lies behind these faces
  Box box{};
};

class NestedCells {
 public:
  NestedCells(const Arrangement& arrangement, const Patches& patches, DisjointSets& sides)
      : arrangement_(arrangement), patches_(patches), sides_(sides), sets_(sides) {
    for (Index patch = 0; patch < patches.size(); ++patch) sets_.join(2 * patch, 2 * patch + 1);
  }
  Index join();

 private:
  void find_points();
  void find_cells();
  void add_patch(PatchCell& cell, Index patch, bool is_behind) const;
  static bool is_within(const PatchCell& cell, const Vec3& point);
  const PatchCell* find_container(const PatchCell& unbounded) const;

  const Arrangement& arrangement_;
  const Patches& patches_;
  DisjointSets& sides_;
  DisjointSets sets_;
  std::vector<Vec3> points_;
  std::vector<PatchCell> cells_;      ///< the bounded cells of all connected sets of patches
  std::vector<PatchCell> unbounded_;  ///< the unbounded cell of each connected set of patches
};

// Copies the points, divided by the largest coordinate so that no volume overflows.
void NestedCells::find_points() {
  double size = 0;
  for (Index i = 0; i < arrangement_.point_count(); ++i) {
    points_.push_back(arrangement_.position(i));
    size = std::max(size, points_.back().cwiseAbs().maxCoeff());
  }
  for (Vec3& point : points_) point /= size;
}

void NestedCells::add_patch(PatchCell& cell, Index patch, bool is_behind) const {
  for (const Index p : patches_.pieces[patch]) {
    const auto& [a, b, c] = arrangement_.pieces[p].corners;
    cell.surface.faces.push_back(is_behind ? Face{a, b, c} : Face{a, c, b});
    const double volume = points_[a].dot(points_[b].cross(points_[c]));
    cell.volume += is_behind ? volume : -volume;
    for (const Index corner : {a, b, c}) cell.box.extend(points_[corner]);
  }
}

void NestedCells::find_cells() {
  std::vector<PatchCell> of_side(2 * patches_.size());
  for (Index side = 0; side < of_side.size(); ++side) {
    PatchCell& cell = of_side[sides_.find(side)];
    cell.side = sides_.find(side);
    cell.set = sets_.find(side);
    add_patch(cell, side / 2, side % 2 == 1);
  }
  std::vector<PatchCell*> least(of_side.size(), nullptr);
  for (PatchCell& cell : of_side) {
    if (cell.side == no_index) continue;
    PatchCell*& best = least[cell.set];
    if (best == nullptr || cell.volume < best->volume) best = &cell;
  }
  for (PatchCell& cell : of_side)
    if (cell.side != no_index)
      (least[cell.set] == &cell ? unbounded_ : cells_).push_back(std::move(cell));
  for (PatchCell& cell : cells_) cell.surface.positions = points_;
}

bool NestedCells::is_within(const PatchCell& cell, const Vec3& point) {
  return cell.box.contains(point) && SolidAngleWinding(cell.surface)(point).rounded() == 1;
}

// Returns the smallest bounded cell of other connected sets that contains the set with the outer
// cell `unbounded`, or null. Cells that contain this set are nested, so the smallest one surrounds
// it directly.
const PatchCell* NestedCells::find_container(const PatchCell& unbounded) const {
  const auto& [a, b, c] = unbounded.surface.faces.front();
  const Vec3 point = (points_[a] + points_[b] + points_[c]) / 3;
  const PatchCell* best = nullptr;
  for (const PatchCell& cell : cells_) {
    if (cell.set == unbounded.set || (best != nullptr && best->volume <= cell.volume)) continue;
    if (is_within(cell, point)) best = &cell;
  }
  return best;
}

Index NestedCells::join() {
  find_points();
  find_cells();
  std::optional<Index> outermost;
  for (const PatchCell& cell : unbounded_) {
    const PatchCell* container = find_container(cell);
    if (container == nullptr && !outermost) outermost = cell.side;
    sides_.join(cell.side, container == nullptr ? *outermost : container->side);
  }
  return *outermost;
}

}  // namespace

Index join_nested_cells(const Arrangement& arrangement, const Patches& patches,
                        DisjointSets& sides) {
  return NestedCells(arrangement, patches, sides).join();
}

}  // namespace transformesh
