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
  /// Resolution of the view at the point, including foreshortening and a reduction near contours.
  /// The value 1 is a view of typical pixel size along the normal. 0 if the point is not visible.
  float quality = 0;
  std::array<std::uint8_t, 3> color{};
};

/// Exposure correction of a view: one factor for each of the channels red, green and blue.
using Gain = Eigen::Array3f;

/// The colors of a surface point in the four views of best quality. The blend of the colors weights
/// them by the 16th power of their quality. The blend thus nearly equals the best view almost
/// everywhere, and changes smoothly where another view becomes the best. If three or more views are
/// good, colors far from their median, such as highlights and occluders, have hardly any weight. An
/// object takes 32 bytes.
class BestViewColors {
 public:
  /// Ties are broken by insertion order. Indices of views above 65535 are stored as 65535.
  void add(const ViewColor& color, std::size_t view);
  bool is_seen() const { return best_[0].quality > 0; }
  /// Returns the number of good views, whose quality is at least 0.6 times the best quality. Views
  /// are sorted by decreasing quality, so good views have the indices 0 to count_good() - 1.
  std::size_t count_good() const;
  std::size_t view(std::size_t i) const { return best_[i].view; }
  Eigen::Array3f intensities(std::size_t i) const;

  /// Returns the blended color, from 0 to 255 per channel. `gains` has the gain of each view.
  Eigen::Array3f blend(std::span<const Gain> gains) const;
  /// Returns the mean difference between `color` and the colors in the good views, after exposure
  /// correction by `gains`.
  float difference(const Eigen::Array3f& color, std::span<const Gain> gains) const;

 private:
  struct Held {
    std::uint16_t quality = 0;  ///< quality, coded in 16 bits; a larger code means a better quality
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
