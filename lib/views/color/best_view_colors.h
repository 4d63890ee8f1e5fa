/// The colors of the views that observe a place of a surface best, and their blend.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace transformesh {

/// Color and quality of a place in one view.
struct ViewColor {
  float quality = 0;  ///< pixels per usual pixel, foreshortened; 0: nothing is seen
  std::array<std::uint8_t, 3> color{};
};

/// Per-channel exposure correction: pixel values are multiplied by (r, g, b).
using Gain = Eigen::Array3f;

/// The four best. Their blend weighs qualities by the 16th power: nearly everywhere it is what the
/// best view shows, and where another one takes over it goes smoothly from one to the other. Where
/// three or more see the place about as well, those that differ from their median, as highlights
/// and what is not part of the surface do, hardly count. 32 bytes.
class BestViewColors {
 public:
  /// Ties are broken by insertion order; views beyond 65535 count as that one.
  void add(const ViewColor& color, std::size_t view);
  bool is_seen() const { return best_[0].quality > 0; }
  /// How many see the place nearly as well as the best one does: the first ones.
  std::size_t count_good() const;
  std::size_t view(std::size_t i) const { return best_[i].view; }
  Eigen::Array3f intensities(std::size_t i) const;

  /// Intensities from 0 to 255, with the gains of all views.
  Eigen::Array3f blend(std::span<const Gain> gains) const;
  /// Mean difference of the good ones' intensities, with gains, from a color.
  float difference(const Eigen::Array3f& color, std::span<const Gain> gains) const;

 private:
  struct Held {
    std::uint16_t quality = 0;  ///< coded, in the same order
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
