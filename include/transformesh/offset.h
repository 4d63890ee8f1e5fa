/// The offset surface of a closed surface. Outwards: the boundary of the union of balls around all
/// its points. Inwards: the boundary of the points at least as deep inside. A self-intersecting
/// source is cleaned first. The surface moves along the gradient of its distance from the source in
/// the iterations of an evolution (iteration.h). Parts merge, split and vanish, and outer corners
/// become round.
///
/// Guarantees: the result is an oriented manifold without self-intersections, subject to the limits
/// of remesh(). Not guaranteed: the exact offset; the result reports the deviation. Concave corners
/// are rounded by about an edge length. Parts thinner than an edge may be lost, which is reported.
/// Cavities stay. Columns are carried as by clean() and remesh().
#pragma once

#include <cstddef>

#include "transformesh/iteration.h"

namespace transformesh {

struct OffsetOptions {
  double distance = 0;           ///< distance of the offset; input units; negative: inwards; not 0
  double edge = 0;               ///< edges are 0.7 to 1.5 times this; input units; 0: offset_edge()
  std::size_t iterations = 500;  ///< limit of iterations
};

/// Deviation of the result from the true offset, at sample points of both surfaces. Input units.
struct OffsetDeviation {
  double rms = 0;     ///< root mean square of |distance from the source - `distance`|, by area
  double most = 0;    ///< largest | distance from the source - `distance` | at samples and vertices
  double missed = 0;  ///< largest distance of a point on the true offset from the result
  Vec3 missed_at = Vec3::Zero();  ///< the point of the true offset at the distance `missed`
};

struct OffsetResult {
  std::size_t iterations = 0;
  bool has_arrived = false;  ///< vertices are within 1/100 edge of the offset, or came no closer
  /// True if points of the true offset are farther from the result than edges explain: a thin part
  /// or its rim is lost.
  bool has_missed = false;
  double edge = 0;  ///< edge length that was used; input units
  Topology topology;
  OffsetDeviation deviation;
  bool is_done() const { return has_arrived && !has_missed; }
};

/// Returns the mean edge, at most half the distance and diagonal / 60, and at least diagonal / 400.
double offset_edge(const Mesh& mesh, double distance);

/// Throws UsageError if the distance is 0 or not finite, and InputError if the mesh is open or not
/// oriented. Throws GoalError if nothing is left (inwards), or as clean() does.
OffsetResult offset(Document& document, const OffsetOptions& options,
                    const Progress& progress = Progress());

}  // namespace transformesh
