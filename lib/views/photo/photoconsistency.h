/// Computes the photoconsistency of a surface, and its exact derivative with respect to every
/// vertex. References: Zaharescu, Boyer & Horaud, TPAMI 33(4), 2011, section 5.3.1; Pons, Keriven &
/// Faugeras, IJCV 72(2), 2007.
///
/// Every pixel of the reference view of a pair is projected onto the surface and from there into
/// the other view (warp.h). Windows of both images are compared by their correlation cc, with the
/// weight rho (correlation.h). The energy is the sum of rho (1 - cc) over pixels and pairs. To
/// compare meshes, use the mean dissimilarity, which is energy / weight, because the number of
/// pixels changes with the surface.
///
/// The derivative treats visibility and rho as constant. It is thus exact for movements that change
/// no contour and no border of an image. Only the second image of a pair is differentiated; pass
/// each pair in both orders to differentiate both images. Pairs without overlap contribute nothing.
///
/// O(views * faces + pairs * pixels) time. Memory: 46 bytes per visible pixel of one view and
/// thread, and 72 bytes per face. Parallel over views; the result does not depend on the number of
/// threads.
#pragma once

#include <span>

#include "transformesh/control.h"
#include "transformesh/mesh.h"
#include "views/cameras/view.h"
#include "views/cameras/view_pairs.h"
#include "views/images/interpolation.h"
#include "views/photo/correlation.h"
#include "views/photo/visible_surface.h"

namespace transformesh {

/// Sums over the compared pixels of all pairs. In sums for a vertex, each pixel is weighted by the
/// barycentric weight of the vertex.
struct Photoconsistency {
  double energy = 0;
  /// The sum that is differentiated; equals `energy` if CorrelationOptions::robust is 0.
  double loss = 0;
  double weight = 0;       ///< sum of the weights of all correlation windows
  std::size_t pixels = 0;  ///< number of compared pixels, over all pairs
  /// Number of pixels that show the surface, over all pairs, whether compared or not.
  std::size_t visible = 0;
  std::vector<Vec3> gradient;  ///< derivative of `loss` with respect to the position of each vertex
  /// For each vertex, half of the Gauss-Newton approximation of the second derivative of `loss`,
  /// for movements along its normal.
  std::vector<double> curvature;
  /// For each vertex, the sum of its barycentric weights over compared pixels.
  std::vector<double> coverage;
};

/// Compares `pairs` of views on `mesh`. `seen` must have been constructed from `mesh` and `views`.
/// Throws UsageError if options are out of range, and if a pair refers to a view that does not
/// exist.
Photoconsistency photoconsistency(const Mesh& mesh, std::span<const View> views,
                                  const SeenViews& seen, std::span<const ViewPair> pairs,
                                  const PhotoconsistencyOptions& options = {},
                                  const Progress& progress = {});

}  // namespace transformesh
