/// Keeps an evolving surface well sampled (paper 5.1.2): edge lengths in an interval, vertices of
/// valence 6, round triangles. Each iteration splits, collapses, flips and smooths, in the order of
/// Botsch & Kobbelt, "A remeshing approach to multiresolution modeling", SGP 2004.
///
/// Guarantees for an oriented manifold with or without borders: the result is one too. Genus and
/// number of components change only by small components that are removed and by `pinch`. No step
/// adds a self-intersection or a face without area; intersections of the input stay unless `pinch`
/// cleans the mesh. Slivers are removed first. Surviving vertices and faces keep their order,
/// attributes are interpolated. Not preserved: lists of texture coordinates. Not guaranteed: that
/// every edge length is in the interval. Deterministic for any number of threads; O(n log n); about
/// 150 bytes per face.
#pragma once

#include "transformesh/remesh_options.h"

namespace transformesh {

struct RemeshResult {
  struct RemovedComponents {
    std::size_t count = 0, faces = 0;
    double area = 0, volume = 0;  ///< sums of absolute values over the removed components
  } components_removed;           ///< components that are too small for the edge lengths
  std::size_t splits = 0, collapses = 0, flips = 0;
  std::size_t refused = 0;           ///< steps refused in the last iteration to keep guarantees
  std::size_t kept_out = 0;          ///< steps refused because of `keep_out`
  std::size_t films_kept = 0;        ///< collapses that `min_film` refused in the last iteration
  std::size_t pinched = 0;           ///< thin parts that were cut along a loop and capped
  std::size_t pinch_refused = 0;     ///< loops that stay uncut because no caps fit
  std::size_t near_keep_out = 0;     ///< input faces nearer to `keep_out` than its gap
  std::size_t degenerate_faces = 0;  ///< remaining faces with height < longest edge / 1000
  /// Degenerate faces that stay because they are only a few coordinate spacings high.
  std::size_t slivers_kept = 0;
  Vec3 first_sliver = Vec3::Zero();    ///< a corner of the first degenerate face that stays
  std::size_t faces_without_area = 0;  ///< slivers that have no area and could not be removed
  double feature_angle_deg = 180;
  StaleColumns columns;
};

/// Throws UsageError for options out of range. Throws InputError if the mesh is not an oriented
/// manifold, has no faces or sizes, or meets the obstacle. Throws GoalError if no face is left.
RemeshResult remesh(Mesh& mesh, const RemeshOptions& options, const Progress& progress = {});

}  // namespace transformesh
