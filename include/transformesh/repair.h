/// Makes a solid of any mesh: closed, oriented outwards, manifold, free of self-intersections. The
/// input may be a soup, open, double-sided, misoriented, inside out, in several parts, cracked, or
/// intersect itself. Measures what is wrong and applies the least change in a fixed order. Places
/// and the sides of cracks are joined, faces oriented, and second sides dropped. Then holes are
/// filled, bodies turned outwards, the mesh cleaned, and shards dropped.
///
/// Guarantees: a result passes check_mesh() with `closed` and `intersections`, unless `keep_open`
/// leaves borders. A solid is unchanged. The steps, applied one after the other to the mesh as it
/// is written in between, give the same mesh. Cavities stay cavities. Throws GoalError if no solid
/// can be made, with the reason, or if `max_change` would be exceeded. Deterministic for any number
/// of threads. Cost: that of the steps.
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
  bool keep_open = false;  ///< fill no holes
  /// Largest distance of the result from the surface of the input; input units; > 0.
  double max_change = std::numeric_limits<double>::infinity();
  Scalar coordinate = Scalar::float64;  ///< the type in which positions will be written
};

/// One operation that was applied.
struct RepairStep {
  /// The options of stitch(), fill_holes(), clean() or select().
  std::variant<StitchOptions, FillOptions, CleanOptions, SelectionOptions> operation;
  std::vector<std::string> findings;          ///< counts with what was done: "3 holes filled"
  std::size_t count = 0;                      ///< sum of these counts
  Vec3 place = Vec3::Zero();                  ///< corner of the first face that changed
  double area_change = 0, volume_change = 0;  ///< after the step less before; input units
  double lost_share = 0;                      ///< share of the area of faces that are gone
  Vec3 lost_place = Vec3::Zero();             ///< a corner of a face that is gone
};

struct RepairResult {
  Mesh mesh;
  std::vector<RepairStep> steps;  ///< none if the input is a solid
  bool same_triangles = false;    ///< only vertices were joined, if anything was done
  double crack_width = 0;         ///< largest distance between the sides of cracks; input units
  double area_before = 0, area_after = 0;      ///< input units squared
  double volume_before = 0, volume_after = 0;  ///< closed components only; input units cubed
};

RepairResult repair(const Mesh& mesh, const RepairOptions& options = {},
                    const Progress& progress = Progress());

}  // namespace transformesh
