/// Makes the initial mesh of a reconstruction (paper 5.3): the visual hull, or a given mesh. A
/// given mesh may be inaccurate and have another topology than the object. It is clipped by the
/// hull of exact masks.
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
  std::optional<Mesh> outlined;       ///< hull whose outlines replace masks
  std::optional<Document> unclipped;  ///< the given mesh, cleaned, if it is closed and was clipped
  /// Reason why the mesh is made from depth maps; empty if it is not.
  std::string why_dense;
};

/// Replaces the document's mesh by the initial mesh, cleaned and rounded as written to a file.
/// Views without masks get silhouettes if there is a threshold; in this case returns the hull of
/// the silhouettes. Edges of a hull are 3 `pixel` long, so that the hull would shave an accurate
/// mesh. A given mesh is only clipped if a vertex is more than a pixel outside of a mask, or if the
/// mesh has holes, which the hull closes. Throws as visual_hull() and clean() do. Throws GoalError
/// if the given mesh does not intersect the hull.
InitialMesh make_initial_mesh(Document& document, std::vector<View>& views,
                              const InitialMeshOptions& options, double pixel,
                              const Progress& progress = Progress());

/// Returns the hull of the views' masks. Views without masks first get silhouettes by the
/// threshold, which must agree (check_views). `edge` is HullOptions::edge.
Mesh hull_of(std::vector<View>& views, const InitialMeshOptions& options,
             std::optional<double> edge, const Progress& progress = Progress());

/// Sets the silhouette of each view to that of the mesh. Throws InputError, with the name of the
/// view, if a view does not show the mesh.
void outline(std::vector<View>& views, const Mesh& mesh);

/// Returns the length of a pixel's side at the point at which the cameras look.
double pixel_size(const std::vector<View>& views);

/// Crops packed views to the mesh and their silhouettes, with a margin for a surface that moves.
/// Pixels outside count as unknown afterwards.
void crop_views(std::vector<View>& views, const Mesh& mesh);

}  // namespace transformesh
