/// What photographs show at one place of a surface: the best of them, and their blend.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace transformesh {

/// What one photograph shows.
struct Glimpse {
  float quality = 0;  ///< pixels per usual pixel, foreshortened; 0: nothing is seen
  std::array<std::uint8_t, 3> color{};
};

/// The four best. Their blend weighs qualities by the 16th power: nearly everywhere it is what the
/// best view shows, and where another one takes over it goes smoothly from one to the other. Where
/// three or more see the place about as well, those that differ from their median, as highlights
/// and what is not part of the surface do, hardly count.
class Glimpses {
 public:
  /// Of equal ones those that came first are better.
  void add(const Glimpse& glimpse);
  bool is_seen() const { return best_[0].quality > 0; }
  /// Levels from 0 to 255.
  Eigen::Array3f blend() const;
  /// Mean difference of the views' levels from a color, over all that see it nearly as well as the
  /// best one does.
  float difference(const Eigen::Array3f& color) const;

 private:
  std::size_t count_as_good(float share) const;

  std::array<Glimpse, 4> best_{};
};

}  // namespace transformesh
