/// What of an image a mesh covers.
#pragma once

#include <span>
#include <vector>

#include "tm/picture/rasterize.h"
#include "tm/views/cameras/view.h"

namespace transformesh {

/// 255 where the centre of a pixel sees the mesh, else 0. Cost and determinism as of rasterize.
GrayImage mesh_silhouette(const Mesh& mesh, const Camera& camera);

/// The same in the photograph, or else in the silhouette, of a view.
GrayImage mesh_silhouette(const Mesh& mesh, const View& view);

/// How well that agrees with the silhouette of each view: silhouette_agreement.
std::vector<double> silhouette_agreements(const Mesh& mesh, std::span<const View> views);

}  // namespace transformesh
