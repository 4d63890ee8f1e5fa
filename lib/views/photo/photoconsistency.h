/// How well photographs agree on a surface, and the exact derivative of that by every vertex
/// (paper 5.3.1; Pons, Keriven & Faugeras, IJCV 72(2), 2007).
///
/// For each pair every pixel of the reference view is carried over the surface into the other view
/// (warp.h) and both are compared in windows (correlation.h). The energy is the sum of
/// rho (1 - cc) over pixels and pairs; energy / weight, the mean dissimilarity, is what to compare
/// between meshes, because the pixels change with the surface.
///
/// The derivative holds what is seen where, and rho, as they are: it is exact for movements that
/// change no contour and no border of an image. Only the second image of a pair is differentiated:
/// give both orders. Views without overlap contribute nothing.
/// Cost: O(views * faces + pairs * pixels); memory 46 bytes a pixel of what one view sees for
/// each thread, and 72 a face. In parallel over views; the same bytes for any number of threads.
#pragma once

#include <span>

#include "mesh/mesh.h"
#include "support/progress.h"
#include "views/cameras/view.h"
#include "views/cameras/view_pairs.h"
#include "views/images/interpolation.h"
#include "views/photo/correlation.h"
#include "views/photo/visible_surface.h"

namespace transformesh {

struct PhotoconsistencyOptions {
  CorrelationOptions correlation;
  Interpolation interpolation = Interpolation::catmull_rom;
  double depth_tolerance = 0.005;  ///< share of the depth by which hidden points are behind; >= 0
};

/// Sums over the compared pixels of all pairs; those of a vertex by its barycentric weight l in
/// each.
struct Photoconsistency {
  double energy = 0;
  double loss = 0;             ///< the sum that is differentiated: the energy, if not robust
  double weight = 0;           ///< sum of rho
  std::size_t pixels = 0;      ///< compared, over all pairs
  std::size_t visible = 0;     ///< pixels that see the surface, over all pairs, compared or not
  std::vector<Vec3> gradient;  ///< derivative of the loss by the position
  /// Second derivative by a movement along the normals, after Gauss and Newton, halved.
  std::vector<double> curvature;
  std::vector<double> coverage;  ///< sums of l
};

/// `seen` is of mesh and views. Throws UsageError for options out of range and for a
/// pair of views that do not exist.
Photoconsistency photoconsistency(const Mesh& mesh, std::span<const View> views,
                                  const SeenViews& seen, std::span<const ViewPair> pairs,
                                  const PhotoconsistencyOptions& options = {},
                                  const Progress& progress = {});

}  // namespace transformesh
