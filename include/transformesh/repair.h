/// Turns any mesh into a solid: closed, oriented outwards, manifold, free of self-intersections.
/// The input may be a soup, open, double-sided, misoriented, inside out, in several parts, cracked,
/// or self-intersecting. Measures the defects and applies the least change in a fixed order. Joins
/// equal positions and the sides of cracks, orients faces, and drops one side of double-sided
/// parts. Then fills holes, turns bodies outwards, cleans the mesh, and drops tiny components
/// (shards).
///
/// Guarantees: a result passes check_mesh() with `closed` and `intersections`, unless `keep_open`
/// leaves borders. A solid is unchanged. The steps, applied one after the other to meshes that are
/// written and read between the steps, give the same mesh. Cavities stay cavities. Throws
/// GoalError, with the reason, if no solid can be made, or if `max_change` would be exceeded.
/// Deterministic for any number of threads. Cost: that of the steps.
#pragma once

#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "transformesh/clean.h"
#include "transformesh/fill.h"
#include "transformesh/select.h"
#include "transformesh/stitch.h"

namespace transformesh {

struct RepairOptions {
  bool keep_open = false;  ///< leave holes open
  /// Largest distance of the result from the surface of the input; input units; > 0.
  double max_change = std::numeric_limits<double>::infinity();
  Scalar coordinate = Scalar::float64;  ///< the type in which positions will be written
};

/// One operation that was applied.
struct RepairStep {
  /// The options of stitch(), fill_holes(), clean() or select().
  std::variant<StitchOptions, FillOptions, CleanOptions, SelectionOptions> operation;
  std::vector<std::string> findings;  ///< counts and actions, such as "3 holes filled"
  std::size_t count = 0;              ///< sum of the counts in `findings`
  Vec3 place = Vec3::Zero();          ///< corner of the first face that changed
  /// Values after the step minus values before; input units.
  double area_change = 0, volume_change = 0;
  double lost_share = 0;           ///< area of removed faces / area before; [0, 1]
  Vec3 lost_place = Vec3::Zero();  ///< corner of a removed face
};

struct RepairResult {
  Mesh mesh;
  std::vector<RepairStep> steps;  ///< empty if the input is a solid
  bool same_triangles = false;    ///< nothing was done, or only vertices were joined
  double crack_width = 0;         ///< largest distance between the sides of cracks; input units
  double area_before = 0, area_after = 0;      ///< in squared input units
  double volume_before = 0, volume_after = 0;  ///< sums over closed components; cubic units
};

RepairResult repair(const Mesh& mesh, const RepairOptions& options = {},
                    const Progress& progress = Progress());

}  // namespace transformesh
