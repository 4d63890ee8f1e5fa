/// Silhouettes: where an image shows the object. See contour_distance.h for their intensities.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "raster/camera.h"
#include "raster/rasterize.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"

namespace transformesh {

/// The intensity that best divides the pixels of all images into dark and bright ones (Otsu, "A
/// threshold selection method from gray-level histograms", IEEE Trans. SMC 9, 1979), in the middle
/// of the intensities that no pixel has. From 0.5 to 254.5.
double dividing_threshold(std::span<const GrayImage> images);

/// The silhouette of a bright object before a dark background. Its contour is where the blurred
/// image crosses the intensity, except where gaps are closed (dilated and eroded by a disc). Throws
/// UsageError for options out of range. O(pixels).
GrayImage threshold_silhouette(const GrayImage& image, const ThresholdOptions& options = {});

/// 255 inside and 0 outside: as masks in files are.
GrayImage binary_silhouette(const GrayImage& silhouette);

/// Share of the pixels that are inside.
double inside_share(const GrayImage& silhouette);

/// Intersection over union of the insides of two silhouettes of one size; 1 where both are empty.
/// Throws UsageError for other sizes.
double silhouette_agreement(const GrayImage& first, const GrayImage& second);

/// 255 where the center of a pixel sees the mesh, else 0. Cost and determinism as of rasterize.
GrayImage mesh_silhouette(const Mesh& mesh, const Camera& camera);

/// The same in the photograph, or else in the silhouette, of a view.
GrayImage mesh_silhouette(const Mesh& mesh, const View& view);

/// For each view the silhouette_agreement of its silhouette with that of the mesh.
std::vector<double> silhouette_agreements(const Mesh& mesh, std::span<const View> views);

}  // namespace transformesh
