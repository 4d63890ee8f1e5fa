/// Internal interface of the visual hull (hull.h): its bounding box, its implicit function on a
/// grid, and visual_hull() for internal View objects.
#pragma once

#include <span>

#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/hull/marching_tetrahedra.h"

namespace transformesh {

/// Returns the smallest axis-parallel box around all points that are in front of every camera and
/// project into the bounding rectangle of every silhouette, enlarged by one pixel. Solves a linear
/// program exactly. A side of a rectangle that lies at the border of the image is not a constraint,
/// because the object may continue beyond the image. A view without silhouette only requires that
/// the object is in front of its camera. Throws InputError, with the name of the view, if a
/// silhouette has no pixel inside. Also throws InputError if no point satisfies all constraints, or
/// if the silhouettes do not bound the object on all sides.
Box silhouette_box(std::span<const View> views);

/// Overload of the public visual_hull() for the internal type View instead of the public type
/// Views.
HullResult visual_hull(std::span<const View> views, const HullOptions& options = {},
                       const Progress& progress = {});

/// Returns the implicit function of the visual hull (F in hull.h) at the nodes of a grid. Values
/// are clamped to plus and minus four cell sides. Ignores `options.keep`: the zero set contains all
/// components. Throws as visual_hull() does, and takes about as long.
ValueGrid hull_values(std::span<const View> views, const HullOptions& options = {},
                      const Progress& progress = {});

/// Removes components of non-positive volume, and components of less than `keep` times the volume
/// of the largest one. Returns the number of removed components.
std::size_t drop_components(Mesh& mesh, double keep);

}  // namespace transformesh
