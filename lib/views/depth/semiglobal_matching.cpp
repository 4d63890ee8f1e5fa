#include "views/depth/semiglobal_matching.h"

#include <algorithm>
#include <limits>

namespace transformesh {
namespace {

class Paths {
 public:
  Paths(const MatchingCosts& costs, const SemiglobalOptions& options)
      : costs_(costs), options_(options), sums_(costs) {
    std::fill(sums_.values.begin(), sums_.values.end(), 0.0F);
    for (int y = 0; y < costs.rows; ++y) {
      for (int x = 0; x < costs.columns; ++x) {
        const std::span<const float> values = costs.at(x, y);
        shows_.push_back(std::any_of(values.begin(), values.end(), [](float v) { return v < 1; }));
      }
    }
  }

  MatchingCosts run() {
    for (const int dy : {-1, 0, 1})
      for (const int dx : {-1, 0, 1})
        if (dx != 0 || dy != 0) go(dx, dy);
    return std::move(sums_);
  }

 private:
  bool is_in(int x, int y) const {
    return x >= 0 && y >= 0 && x < costs_.columns && y < costs_.rows;
  }

  /// Follows all paths in direction (dx, dy). A path begins at a pixel whose predecessor would be
  /// outside of the rectangle.
  void go(int dx, int dy) {
    for (int y = 0; y < costs_.rows; ++y)
      for (int x = 0; x < costs_.columns; ++x)
        if (!is_in(x - dx, y - dy)) follow(x, y, dx, dy);
  }

  void follow(int x, int y, int dx, int dy) {
    bool begins = true;
    for (; is_in(x, y); x += dx, y += dy) {
      const bool shows = shows_[costs_.pixel(x, y)];
      if (shows) enter(costs_.at(x, y), sums_.at(x, y), begins);
      begins = !shows;
    }
  }

  /// Extends the paths to all planes of the next pixel. Subtracts the least cost of the previous
  /// pixel, which keeps numbers small and does not change the order of the planes.
  void enter(std::span<const float> costs, std::span<float> sums, bool begins) {
    constexpr float none = std::numeric_limits<float>::infinity();
    const std::size_t count = costs.size();
    now_.resize(count + 2);
    if (begins) {
      std::copy(costs.begin(), costs.end(), now_.begin() + 1);
    } else {
      const float jump = least_ + options_.far_step;
      for (std::size_t k = 0; k < count; ++k) {
        const float step = std::min(before_[k], before_[k + 2]) + options_.near_step;
        now_[k + 1] = costs[k] + std::min({before_[k + 1], step, jump}) - least_;
      }
    }
    now_.front() = now_.back() = none;
    least_ = *std::min_element(now_.begin(), now_.end());
    for (std::size_t k = 0; k < count; ++k) sums[k] += now_[k + 1];
    std::swap(before_, now_);
  }

  const MatchingCosts& costs_;
  SemiglobalOptions options_;
  MatchingCosts sums_;
  std::vector<bool> shows_;
  /// Costs of the cheapest paths to each plane, at the previous and at the current pixel. An entry
  /// with infinite cost is added at both ends, so that the first and last plane need no special
  /// case.
  std::vector<float> before_, now_;
  float least_ = 0;  ///< minimum of `before_`
};

}  // namespace

MatchingCosts semiglobal_costs(const MatchingCosts& costs, const SemiglobalOptions& options) {
  return Paths(costs, options).run();
}

}  // namespace transformesh
