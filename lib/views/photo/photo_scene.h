/// Calibrated photographs at one scale, made ready for steps of a surface towards them
/// (paper 5.3.1).
#pragma once

#include <span>
#include <vector>

#include "views/cameras/view.h"
#include "views/cameras/view_pairs.h"

namespace transformesh {

struct PhotoScene {
  std::vector<View> views;               ///< without silhouettes
  std::vector<PackableImage> distances;  ///< to the silhouettes; empty where there is none
  std::vector<ViewPair> pairs;
  double pixel = 0;  ///< length of a pixel's side where the cameras look
};

/// Views at a smaller scale (at_scale), and which of them to compare (choose_pairs). Throws
/// InputError where there is no such pair, UsageError as at_scale does. O(pixels), in parallel over
/// views; the same for any number of threads. Of views that are packed, so is the scene: 2 bytes a
/// pixel, or 3 of photographs with intensities between those of 8 bits.
PhotoScene photo_scene(std::span<const View> views, double scale, const PairOptions& pairs = {});

/// The same, and images and silhouettes of the views are gone, each as soon as it is not needed.
PhotoScene take_photo_scene(std::span<View> views, double scale, const PairOptions& pairs = {});

}  // namespace transformesh
