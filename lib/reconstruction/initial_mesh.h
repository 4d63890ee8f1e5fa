/// Makes the initial mesh of a reconstruction (paper 5.3): the visual hull, or a given mesh. A
/// given mesh may be inaccurate and have another topology than the object. It may be intersected
/// with the hull of exact masks.
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

struct InitialMesh {
  /// Visual hull of thresholded silhouettes, if views had no masks. Its outlines then replace these
  /// silhouettes.
  std::optional<Mesh> outlined;
  /// The cleaned given mesh before the intersection with the hull, if it was closed and was
  /// intersected.
  std::optional<Document> unclipped;
  /// Reason why the mesh was made from depth maps; empty if it was not.
  std::string why_dense;
};

/// Replaces the document's mesh by the initial mesh, cleaned and rounded as written to a file. If
/// views have no masks, they get silhouettes by `threshold` or, if no mesh is given either, by
/// Otsu's threshold. `outlined` is then the hull of these silhouettes. If no mesh is given and the
/// silhouettes have no hull, the mesh is made from depth maps. The edges of a hull are 3 `pixel`
/// long, so that the intersection with a hull could make an accurate mesh worse. A given mesh is
/// therefore intersected only if a vertex is more than a pixel outside of an exact mask, or if the
/// mesh is open. Throws as visual_hull() and clean() do. Throws GoalError if the given mesh does
/// not intersect the hull.
InitialMesh make_initial_mesh(Document& document, std::vector<View>& views,
                              const InitialMeshOptions& options, double pixel,
                              const Progress& progress = Progress());

/// Returns the hull of the views' masks. Views without masks first get silhouettes by the
/// threshold, which check_views() checks. `edge` is HullOptions::edge.
Mesh hull_of(std::vector<View>& views, const InitialMeshOptions& options,
             std::optional<double> edge, const Progress& progress = Progress());

/// Sets the silhouette of each view to that of the mesh. Throws InputError, with the name of the
/// view, if a view does not show the mesh.
void outline(std::vector<View>& views, const Mesh& mesh);

/// Returns the median length of a pixel's side at the point at which the cameras look
/// (viewed_point()); input units.
double pixel_size(const std::vector<View>& views);

/// Crops views with packed images (packable_image.h) to a rectangle around the mesh and their
/// silhouette. A margin lets the surface move. Pixels outside of the rectangle count as unknown
/// afterwards.
void crop_views(std::vector<View>& views, const Mesh& mesh);

}  // namespace transformesh
