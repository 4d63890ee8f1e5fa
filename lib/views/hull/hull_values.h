/// The function whose zero set is the visual hull (hull.h), and hulls of views in a list.
#pragma once

#include <span>

#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/hull/marching_tetrahedra.h"

namespace transformesh {

/// Returns the smallest box around all points that lie before every camera and project into the
/// bounding rectangle of every silhouette, one pixel wider: a linear program, solved exactly. A
/// side of a rectangle on the border of its image bounds nothing, as the object may continue beyond
/// it. Views without silhouette count as cameras that have the object before them. Throws
/// InputError, with the name of the view, for a silhouette without a pixel inside; if no point is
/// left, and if the silhouettes do not bound the object on all sides.
Box silhouette_box(std::span<const View> views);

/// Does what visual_hull() of hull.h does.
HullResult visual_hull(std::span<const View> views, const HullOptions& options = {},
                       const Progress& progress = {});

/// Returns F on a grid, cut off at four cells. The zero set contains all components: `keep` is not
/// used. Throws and costs as visual_hull().
ValueGrid hull_values(std::span<const View> views, const HullOptions& options = {},
                      const Progress& progress = {});

/// Drops components with less than this fraction of the largest one's volume, and components that
/// are inside out. Returns how many.
std::size_t drop_components(Mesh& mesh, double keep);

}  // namespace transformesh
