/// Collects the colors of a surface point in the views that observe the point best, and blends
/// them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace transformesh {

/// Color and quality of a surface point in one view.
struct ViewColor {
  /// Resolution relative to the usual pixel, foreshortened; 0 if the point is not visible.
  float quality = 0;
  std::array<std::uint8_t, 3> color{};
};

/// Per-channel exposure correction: pixel values are multiplied by (r, g, b).
using Gain = Eigen::Array3f;

/// The four best view colors of a surface point. The blend weights them by the 16th power of their
/// quality. The blend thus nearly equals the best view almost everywhere, and changes smoothly
/// where another view becomes the best. If three or more views are good, views far from the median
/// have hardly any weight, for example highlights and occluders. 32 bytes.
class BestViewColors {
 public:
  /// Ties are broken by insertion order. Indices of views above 65535 are stored as 65535.
  void add(const ViewColor& color, std::size_t view);
  bool is_seen() const { return best_[0].quality > 0; }
  /// Returns the number of views whose quality is at least 0.6 times the best one. These views come
  /// first.
  std::size_t count_good() const;
  std::size_t view(std::size_t i) const { return best_[i].view; }
  Eigen::Array3f intensities(std::size_t i) const;

  /// Returns intensities from 0 to 255, corrected by the gains of all views.
  Eigen::Array3f blend(std::span<const Gain> gains) const;
  /// Returns the mean difference between `color` and the corrected intensities of the good views.
  float difference(const Eigen::Array3f& color, std::span<const Gain> gains) const;

 private:
  struct Held {
    std::uint16_t quality = 0;  ///< coded; codes have the order of the qualities
    std::uint16_t view = 0;
    std::array<std::uint8_t, 3> color{};
  };
  Eigen::Array3f evened(std::size_t i, std::span<const Gain> gains) const {
    return intensities(i) * gains[view(i)];
  }
  float share(std::size_t i) const;

  std::array<Held, 4> best_{};
};

}  // namespace transformesh
