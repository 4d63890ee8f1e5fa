/// Calibrated photographs of one object: cameras, photographs and silhouettes.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "transformesh/errors.h"
#include "transformesh/image.h"
#include "transformesh/pinhole_camera.h"

namespace transformesh {

struct View;  // private to the library

/// Photographs with their cameras. A photograph takes 4 bytes per pixel, 1 if read_views() read it.
class Views {
 public:
  Views();
  explicit Views(std::vector<View> views);
  Views(Views&&) noexcept;
  Views& operator=(Views&&) noexcept;
  ~Views();

  /// Appends a photograph without lens distortion. An empty silhouette means that none is known.
  /// Throws UsageError if both have pixels and their sizes differ.
  void add(const std::string& name, const PinholeCamera& camera, GrayImage photograph,
           GrayImage silhouette = {});

  std::size_t size() const;
  const std::string& name(std::size_t view) const;
  const PinholeCamera& camera(std::size_t view) const;

  std::vector<View>& list() { return *views_; }
  const std::vector<View>& list() const { return *views_; }

 private:
  std::unique_ptr<std::vector<View>> views_;
};

/// Paths of input files. Each is a file, a folder or a pattern.
struct ViewSources {
  std::string cameras;      ///< file of cameras, in any format that tm-cameras(1) lists
  std::string images;       ///< photographs; empty: none
  std::string silhouettes;  ///< silhouettes; empty: none
  bool mirror = false;      ///< the world coordinates of the cameras are left-handed
  /// Called with notes on how masks were read, and on images and cameras that were left out.
  std::function<void(const std::string& note)> on_note = {};
  bool needs_all_images = false;  ///< throw if a named image is missing; else skip its camera
  double reduction = 1;           ///< factor by which photographs and silhouettes are reduced; >= 1
};

/// Reads views in the order of the cameras. If the camera file names images, images are paired with
/// cameras by name, otherwise by the numbers in their names. Lens distortion is removed. Throws
/// InputError, naming the file, if a file cannot be read, images and cameras cannot be paired,
/// sizes disagree, or a silhouette is empty. Parallel; deterministic.
Views read_views(const ViewSources& sources);

}  // namespace transformesh
