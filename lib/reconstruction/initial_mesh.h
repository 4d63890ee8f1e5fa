/// The initial mesh of a reconstruction (paper 5.3): the visual hull, or a given mesh that may be
/// far off and have another topology. Of a given mesh only what is within the hull of exact masks
/// is kept.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/document.h"
#include "transformesh/reconstruction_options.h"
#include "views/cameras/view.h"
#include "views/hull/hull_values.h"
#include "views/hull/silhouette.h"
#include "views/photo/contour_gaps.h"

namespace transformesh {

/// Makes the document's mesh the one to begin with, clean and rounded as written. Views without
/// masks get silhouettes where there is a threshold; then returns their hull, whose outlines are to
/// take the place of masks. Edges of a hull are three `pixel` long. Throws as visual_hull() and
/// clean() do, and GoalError where nothing of the mesh given is within the hull.
std::optional<Mesh> make_initial_mesh(Document& document, std::vector<View>& views,
                                      const InitialMeshOptions& options, double pixel,
                                      const Progress& progress = Progress());

/// The hull of the views' masks; or else of what is brighter than the threshold, which becomes the
/// silhouettes of the views and must agree (check_views). `edge` is HullOptions::edge.
Mesh hull_of(std::vector<View>& views, const InitialMeshOptions& options,
             std::optional<double> edge, const Progress& progress = Progress());

/// What the mesh covers becomes the silhouette of each view. Throws InputError, with the name of
/// the view, where that is nothing.
void outline(std::vector<View>& views, const Mesh& mesh);

/// The length of a pixel's side where the cameras look.
double pixel_size(const std::vector<View>& views);

/// Leaves of views that are packed what is around the mesh and their silhouettes, and some room for
/// a surface that moves: what is beyond is unknown from then on.
void crop_views(std::vector<View>& views, const Mesh& mesh);

}  // namespace transformesh
