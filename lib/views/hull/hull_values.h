/// Internal interface of the visual hull (hull.h): its implicit function, and hulls of lists of
/// views.
#pragma once

#include <span>

#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/hull/marching_tetrahedra.h"

namespace transformesh {

/// Returns the smallest axis-parallel box around all points that are in front of every camera and
/// project into the bounding rectangle of every silhouette. Rectangles are enlarged by one pixel.
/// Solves a linear program exactly. A side of a rectangle at the border of its image is no
/// constraint, because the object may continue beyond it. A view without silhouette only requires
/// that the object is in front of its camera. Throws InputError, naming the view, if a silhouette
/// has no pixel inside. Also throws it if no point satisfies all constraints, and if the
/// silhouettes do not bound the object on all sides.
Box silhouette_box(std::span<const View> views);

/// Equals visual_hull() of hull.h, for a list of views.
HullResult visual_hull(std::span<const View> views, const HullOptions& options = {},
                       const Progress& progress = {});

/// Returns the function F of hull.h on a grid, clamped to plus and minus four cells. Ignores
/// `options.keep`: the zero set contains all components. Throws and costs as visual_hull().
ValueGrid hull_values(std::span<const View> views, const HullOptions& options = {},
                      const Progress& progress = {});

/// Removes components of non-positive volume, and components of less than `keep` times the volume
/// of the largest one. Returns the number of removed components.
std::size_t drop_components(Mesh& mesh, double keep);

}  // namespace transformesh
