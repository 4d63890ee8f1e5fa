/// Options of remesh() (remesh.h).
///
/// `curved` is for surfaces that a flow carries. The new vertex of a split edge lies on the quadric
/// that fits the vertices around the edge. A collapsed edge becomes one of its ends or a point on
/// such a quadric, whichever is nearest to the planes of the old faces. Sliding vertices stay on
/// such quadrics. Creases are borders, features and edges that turn by more than 40 degrees;
/// vertices on them lie on cubics. Without smoothing no other vertex moves. Closed components with
/// an edge shorter than `min_edge` are removed if they have less area than the sphere of that
/// diameter, however long they are. An iteration of an evolution (iteration.h) also pinches loops
/// shorter than `min_edge` if clean() changed a closed mesh. With `min_film`, thin walls and
/// components that are thicker than `min_film` stay, however short their edges are. With `pinch`
/// the mesh must be closed (InputError); if the caps of cuts intersect the surface, the mesh is
/// cleaned.
#pragma once

#include <string>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

enum class Smoothing { none, tangential, laplace, bilaplace };
/// `valence`: flips bring valences nearer to 6; `angle`: flips enlarge the smallest angle.
enum class FlipRule { none, valence, angle };

struct RemeshOptions {
  double min_edge = 0;  ///< shorter edges are collapsed; input units, > 0
  double max_edge = 0;  ///< longer edges are split; input units, >= 1.5 min_edge
  /// Vertex column that multiplies `min_edge` and `max_edge`; empty: none.
  std::string size_column;
  /// > 0: edge lengths follow the curvature, so that faces are at most this far from the smooth
  /// surface; input units.
  double adaptive_error = 0;
  int iterations = 1;        ///< >= 0; 0 removes only small components and degenerate faces
  bool only_smooth = false;  ///< smooth only; no splits, collapses and flips
  FlipRule flip = FlipRule::valence;
  Smoothing smoothing = Smoothing::tangential;  ///< `laplace`, `bilaplace`: not only tangential
  /// Laplacian smoothing moves v to v - b1 dv + b2 d2v, where dv and d2v are Laplacians (smooth.h).
  /// This is b1, in [0, 1].
  double smooth_first = 0;
  double smooth_second = 0;  ///< b2 of the formula above, for bilaplace; in [(b1 - 1) / 2, b1 / 2]
  /// Edges sharper than this stay; [0, 180]; 0: 40 if sharp edges exist.
  double feature_angle_deg = 180;
  bool keep_border = false;  ///< border vertices and edges stay
  bool project = false;      ///< project moved vertices onto the input surface
  bool curved = false;       ///< new vertices lie on quadrics or cubics, as described above
  double min_film = 0;       ///< > 0: no collapse moves the surface by more than half of this
  double pinch = 0;  ///< > 0: cut necks and handles around which a loop is at most this long
  Scalar coordinate = Scalar::float64;  ///< type to which new positions are rounded
  KeepOutOptions keep_out = {};
};

/// Returns options for a surface that a flow carries: `curved`, flips by angle, no smoothing, so
/// that vertices stay where the flow took them. Smoothing would interpolate all vertices at every
/// call.
RemeshOptions curved_remeshing();

}  // namespace transformesh
