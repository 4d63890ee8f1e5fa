/// The surface at a distance from another one: outwards the union of balls around all its points,
/// inwards what is that far inside. A source that intersects itself is cleaned first (clean.h). The
/// surface moves along the gradient of its distance from the source in the iterations of an
/// evolution (iteration.h): short steps, exact cleaning, remeshing. So parts merge, split and
/// vanish as they do, and outer corners become round.
///
/// Guarantees: the result is an oriented manifold without self-intersections, as far as remesh()
/// promises. Not guaranteed: a distance from the true offset; the result reports it. Concave
/// corners of the offset are rounded by about an edge length. Parts thinner than an edge may be
/// lost, which is reported. Cavities stay. Columns are carried as by clean() and remesh().
#pragma once

#include <cstddef>

#include "transformesh/iteration.h"

namespace transformesh {

struct OffsetOptions {
  double distance = 0;  ///< input units; negative: inwards; not 0
  double edge = 0;      ///< edges are 0.7 to 1.5 times as long; input units; 0: offset_edge()
  std::size_t iterations = 500;  ///< at most
};

/// How far the result is from the true offset, over points all over both. Input units.
struct OffsetDeviation {
  double rms = 0;     ///< of how much farther or nearer than `distance` the surface is, by its area
  double most = 0;    ///< the largest of these, vertices included
  double missed = 0;  ///< largest distance from the result of points that are on the true offset
  Vec3 missed_at = Vec3::Zero();  ///< that point
};

struct OffsetResult {
  std::size_t iterations = 0;
  bool has_arrived = false;  ///< vertices are within a hundredth of an edge, or came no closer
  /// True if points of the true offset are farther from the result than edges explain: a thin part
  /// is lost, or its rim.
  bool has_missed = false;
  double edge = 0;  ///< length that was used
  Topology topology;
  OffsetDeviation deviation;
  bool is_done() const { return has_arrived && !has_missed; }
};

/// The mean edge, at most half the distance and a 60th of the diagonal, at least its 400th.
double offset_edge(const Mesh& mesh, double distance);

/// Throws UsageError for a distance that is 0 or not finite, InputError for a mesh that is open or
/// not oriented, GoalError where nothing is left (inwards) or where cleaning throws it.
OffsetResult offset(Document& document, const OffsetOptions& options,
                    const Progress& progress = Progress());

/// Moves the planes of the faces, so that corners stay sharp, and cleans. Throws as offset() does.
void offset_mitered(Mesh& mesh, double distance, Scalar coordinate = Scalar::float64,
                    const Progress& progress = Progress());
/// Makes a solid of an open sheet, which becomes its middle, with mitered corners, and cleans it.
void thicken(Mesh& mesh, double thickness, Scalar coordinate = Scalar::float64,
             const Progress& progress = Progress());

}  // namespace transformesh
