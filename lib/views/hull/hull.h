/// The visual hull: the largest object that has the given silhouettes, as a mesh.
/// Reference: Laurentini, "The visual hull concept for silhouette-based image understanding", PAMI
/// 16 (1994). Meshed as the zero of F(X) = max over views of (distance to the contour of X's pixel,
/// in pixels, positive outside) * depth / focal length, which is a length in the world.
///
/// Where X is outside the image of a view, or behind its camera, the view gives no evidence: it
/// does not carve. What no view carves is part of the hull as far as the box reaches.
#pragma once

#include <optional>
#include <span>

#include "mesh/measure.h"
#include "support/progress.h"
#include "views/cameras/view.h"
#include "views/hull/marching_tetrahedra.h"

namespace transformesh {

/// The smallest box around all points that lie before every camera and project into the bounding
/// rectangle of every silhouette, one pixel wider: a linear program, solved exactly. A side of a
/// rectangle that lies on the border of its image bounds nothing, as the object may go on beyond
/// it. Views without silhouette count as cameras that have the object before them. Throws
/// InputError, with the name of the view, for a silhouette without a pixel inside; where no point
/// is left, and where the silhouettes do not bound the object on all sides.
Box silhouette_box(std::span<const View> views);

struct HullOptions {
  std::optional<Box> box = std::nullopt;  ///< that is searched; default: silhouette_box
  int resolution = 100;                   ///< [4, 4096] cells along the longest side of the box
  /// Size of a cell, > 0, instead of a resolution; faces are about as large.
  std::optional<double> edge = std::nullopt;
  /// [0, 1]: components of less than this share of the largest one's volume are dropped. Few views
  /// leave phantoms: places that every camera takes for the object.
  double keep = 1;
};

struct HullResult {
  Mesh mesh;  ///< closed, oriented 2-manifold without self-intersection
  Box box;    ///< that was searched
  double cell = 0;
  std::size_t dropped_components = 0;
};

/// Views without silhouette are passed over. Throws UsageError for options out of range and for
/// more than 2^28 cells, InputError as silhouette_box does, where no view has a silhouette and
/// where nothing is inside all of them (the object may be smaller than a cell). Only cells near the
/// surface are measured: a quarter of a second for 16 views of 640x480 and 100^3 cells, and 4 bytes
/// a cell. Parallel; the same mesh for any number of threads.
HullResult visual_hull(std::span<const View> views, const HullOptions& options = {},
                       const Progress& progress = {});

/// F on a grid, cut off at four cells, on whose zero the mesh lies with all its components; of the
/// options `keep` is not used. Throws and costs as visual_hull().
ValueGrid hull_values(std::span<const View> views, const HullOptions& options = {},
                      const Progress& progress = {});

/// Drops components of less than this share of the largest one's volume, and those inside out;
/// returns how many.
std::size_t drop_components(Mesh& mesh, double keep);

}  // namespace transformesh
