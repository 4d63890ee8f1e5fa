/// Computes and compares silhouettes. Pixels above 127.5 are inside; see contour_distance.h.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "raster/camera.h"
#include "raster/rasterize.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"

namespace transformesh {

/// Returns the intensity that best divides the pixels of all images into dark and bright ones
/// (Otsu, "A threshold selection method from gray-level histograms", IEEE Trans. SMC 9, 1979). If
/// some intensities between the two classes occur in no pixel, returns the middle of this gap. The
/// result is in [0.5, 254.5].
double dividing_threshold(std::span<const GrayImage> images);

/// Returns the silhouette of a bright object in front of a dark background. Its contour is the
/// curve where the blurred image has the intensity `options.intensity`, except where morphological
/// closing by a disc fills gaps. Throws UsageError if options are out of range. O(pixels).
GrayImage threshold_silhouette(const GrayImage& image, const ThresholdOptions& options = {});

/// Returns the silhouette in two intensities, 255 inside and 0 outside, as in mask files.
GrayImage binary_silhouette(const GrayImage& silhouette);

/// Returns the fraction of the pixels that are inside the silhouette.
double inside_share(const GrayImage& silhouette);

/// Returns intersection over union of the insides of two silhouettes; 1 if both are empty. Throws
/// UsageError if their sizes differ.
double silhouette_agreement(const GrayImage& first, const GrayImage& second);

/// Returns the silhouette of the mesh: 255 at pixels at whose center the mesh is visible, else 0.
/// Takes about as long as rasterize().
GrayImage mesh_silhouette(const Mesh& mesh, const Camera& camera);

/// Renders the mesh at the size of the view's photograph, or of its silhouette if it has no
/// photograph.
GrayImage mesh_silhouette(const Mesh& mesh, const View& view);

/// Returns for each view the silhouette_agreement() of its silhouette and the silhouette of the
/// mesh.
std::vector<double> silhouette_agreements(const Mesh& mesh, std::span<const View> views);

}  // namespace transformesh
