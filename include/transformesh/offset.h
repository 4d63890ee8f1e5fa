/// The offset surface of a closed surface. Outwards: the boundary of the union of balls around all
/// its points. Inwards: the boundary of the points at least as deep inside. A self-intersecting
/// source is cleaned first. The surface moves along the gradient of its distance from the source in
/// the iterations of an evolution (iteration.h). Outer corners become round.
///
/// Guarantees: an oriented manifold without self-intersections, subject to the limits of remesh().
/// The result reports its deviation from the exact offset, and whether parts thinner than an edge
/// are lost. Corners are cut off where they are thinner than an edge. Columns: as by remesh().
#pragma once
#include <cstddef>
#include <optional>

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
  bool has_missed = false;   ///< `missed` is larger than edges explain: a thin part or gap is lost
  double edge = 0;           ///< edge length that was used; input units
  Topology topology;
  OffsetDeviation deviation;
  bool is_done() const { return has_arrived && !has_missed; }
};

/// Mean edge length of `mesh`; at most distance / 2 and diagonal / 60, at least diagonal / 400.
double offset_edge(const Mesh& mesh, double distance);
/// Throws UsageError if the distance is 0 or not finite, and InputError if the mesh is open or not
/// oriented. Throws GoalError if nothing is left (inwards), or as clean() does.
OffsetResult offset(Document& document, const OffsetOptions& options,
                    const Progress& progress = {});

struct MiterDeviation {
  double most = 0;         ///< largest error of the distance by which a face's plane has moved
  Vec3 at = Vec3::Zero();  ///< its vertex, at which over three planes meet or a spike is cut
  bool is_large = false;   ///< `most` is over 5 % of the distance, more than on smooth surfaces
  std::optional<Vec3> remains;  ///< place of a part turned inside out that is kept in the result
};
/// Offsets the planes of the faces; corners stay sharp. Cleans the result. Throws as offset().
MiterDeviation offset_mitered(Mesh& mesh, double distance, Scalar coordinate = Scalar::float64,
                              const Progress& progress = {});
/// Makes a solid around an open sheet, with mitered corners, and cleans it. Throws as offset().
MiterDeviation thicken(Mesh& mesh, double thickness, Scalar coordinate = Scalar::float64,
                       const Progress& progress = {});

}  // namespace transformesh
