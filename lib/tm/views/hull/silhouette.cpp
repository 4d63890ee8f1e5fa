#include "tm/views/hull/silhouette.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <vector>

#include "tm/support/error.h"
#include "tm/views/images/gaussian_blur.h"

namespace transformesh {
namespace {

constexpr float contour_level = 127.5F;
constexpr std::int32_t no_segment = -1;

using Point = Eigen::Vector2f;

struct Segment {
  Point start, end;

  float squared_distance(const Point& point) const {
    const Point along = end - start;
    const float squared_length = along.squaredNorm();
    float share = squared_length > 0 ? (point - start).dot(along) / squared_length : 0.0F;
    share = std::clamp(share, 0.0F, 1.0F);
    return (start + share * along - point).squaredNorm();
  }
};

bool is_inside(float level) { return level > contour_level; }

/// The nearest piece of the contour of each pixel, where that is nearer than `limit`: of all others
/// the distance is said to be that.
class ContourDistance {
 public:
  explicit ContourDistance(const GrayImage& silhouette,
                           float limit = std::numeric_limits<float>::infinity())
      : silhouette_(silhouette),
        squared_(silhouette.width, silhouette.height, limit * limit),
        nearest_(silhouette.pixels.size(), no_segment) {}

  GrayImage compute() {
    for (int y = 0; y + 1 < silhouette_.height; ++y)
      for (int x = 0; x + 1 < silhouette_.width; ++x) trace_cell(x, y);
    sweep_down();
    sweep_up();
    return signed_roots();
  }

 private:
  // Marching squares: the contour leaves and enters the square of four pixel centres.
  void trace_cell(int x, int y) {
    static constexpr std::array<std::array<int, 2>, 4> corners = {
        {{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}}};
    std::array<Point, 4> crossings;
    std::size_t count = 0;
    for (std::size_t side = 0; side < 4; ++side) {
      const auto [ax, ay] = corners[side];
      const auto [bx, by] = corners[(side + 1) % 4];
      const float a = silhouette_.at(x + ax, y + ay);
      const float b = silhouette_.at(x + bx, y + by);
      if (is_inside(a) == is_inside(b)) continue;
      const float share = (contour_level - a) / (b - a);
      const Point start(static_cast<float>(x + ax), static_cast<float>(y + ay));
      const Point end(static_cast<float>(x + bx), static_cast<float>(y + by));
      crossings[count++] = start + share * (end - start);
    }
    for (std::size_t i = 0; i + 1 < count; i += 2)
      add_segment({crossings[i], crossings[i + 1]}, x, y);
  }

  void add_segment(const Segment& segment, int x, int y) {
    const auto index = static_cast<std::int32_t>(segments_.size());
    segments_.push_back(segment);
    for (int dy = 0; dy <= 1; ++dy)
      for (int dx = 0; dx <= 1; ++dx) offer(index, x + dx, y + dy);
  }

  void offer(std::int32_t segment, int x, int y) {
    if (segment == no_segment) return;
    const Point pixel(static_cast<float>(x), static_cast<float>(y));
    const float squared = segments_[static_cast<std::size_t>(segment)].squared_distance(pixel);
    if (squared >= squared_.at(x, y)) return;
    squared_.at(x, y) = squared;
    nearest(x, y) = segment;
  }

  void offer_from(int from_x, int from_y, int x, int y) {
    if (from_x < 0 || from_x >= silhouette_.width || from_y < 0 || from_y >= silhouette_.height)
      return;
    const std::int32_t segment = nearest(from_x, from_y);
    if (segment != nearest(x, y)) offer(segment, x, y);
  }

  void sweep_row(int y, int from_y) {
    const int width = silhouette_.width;
    for (int x = 0; x < width; ++x) {
      for (int dx = -1; dx <= 1; ++dx) offer_from(x + dx, from_y, x, y);
      offer_from(x - 1, y, x, y);
    }
    for (int x = width - 1; x >= 0; --x) offer_from(x + 1, y, x, y);
  }

  void sweep_down() {
    for (int y = 0; y < silhouette_.height; ++y) sweep_row(y, y - 1);
  }
  void sweep_up() {
    for (int y = silhouette_.height - 1; y >= 0; --y) sweep_row(y, y + 1);
  }

  GrayImage signed_roots() const {
    GrayImage distances = squared_;
    for (std::size_t i = 0; i < distances.pixels.size(); ++i) {
      const float root = std::sqrt(squared_.pixels[i]);
      distances.pixels[i] = is_inside(silhouette_.pixels[i]) ? -root : root;
    }
    return distances;
  }

  std::int32_t& nearest(int x, int y) {
    return nearest_[static_cast<std::size_t>(y) * static_cast<std::size_t>(silhouette_.width) +
                    static_cast<std::size_t>(x)];
  }

  const GrayImage& silhouette_;
  GrayImage squared_;
  std::vector<std::int32_t> nearest_;
  std::vector<Segment> segments_;
};

/// The silhouette whose contour is `offset` pixels outside of the one with these distances.
GrayImage offset_silhouette(GrayImage distances, float offset) {
  for (float& pixel : distances.pixels)
    pixel = std::clamp(contour_level * (1 + offset - pixel), 0.0F, 255.0F);
  return distances;
}

/// As the border of the image is no contour, nothing is eroded from there.
GrayImage closed(const GrayImage& silhouette, float radius) {
  // Only distances around the radius count, and what they are propagated through.
  const float limit = radius + 4;
  const GrayImage wide = offset_silhouette(ContourDistance(silhouette, limit).compute(), radius);
  GrayImage narrow = offset_silhouette(ContourDistance(wide, limit).compute(), -radius);
  // Where nothing was closed the contour stays exactly where it was.
  for (std::size_t i = 0; i < narrow.pixels.size(); ++i)
    narrow.pixels[i] = std::max(narrow.pixels[i], silhouette.pixels[i]);
  return narrow;
}

/// How many pixels have each level.
using Histogram = std::array<std::size_t, 256>;

/// The last dark level: where the variance between dark and bright levels, Otsu's equation 14, is
/// largest. Shares that a float could not tell from none do not divide anything.
std::ptrdiff_t otsu_level(const Histogram& counts) {
  const double scale = 1 / std::accumulate(counts.begin(), counts.end(), 0.0);
  double mean = 0;
  for (std::size_t level = 0; level < counts.size(); ++level)
    mean += static_cast<double>(level) * static_cast<double>(counts[level]);
  mean *= scale;

  std::ptrdiff_t best = 0;
  double largest = 0;
  double dark_share = 0;
  double dark_mean = 0;
  for (std::size_t level = 0; level < counts.size(); ++level) {
    const double share = static_cast<double>(counts[level]) * scale;
    dark_mean *= dark_share;
    dark_share += share;
    const double bright_share = 1 - dark_share;
    if (std::min(dark_share, bright_share) < std::numeric_limits<float>::epsilon()) continue;
    dark_mean = (dark_mean + static_cast<double>(level) * share) / dark_share;
    const double bright_mean = (mean - dark_share * dark_mean) / bright_share;
    const double apart = dark_mean - bright_mean;
    const double variance = dark_share * bright_share * apart * apart;
    if (variance <= largest) continue;
    largest = variance;
    best = static_cast<std::ptrdiff_t>(level);
  }
  return best;
}

}  // namespace

double dividing_level(std::span<const GrayImage> images) {
  Histogram counts{};
  for (const GrayImage& image : images)
    for (const float level : image.pixels)
      ++counts[static_cast<std::size_t>(std::clamp(std::lround(level), 0L, 255L))];
  const auto is_used = [](std::size_t count) { return count > 0; };
  if (std::none_of(counts.begin(), counts.end(), is_used)) return contour_level;

  // It is the last of the dark levels that are used, or one of those after it that are not.
  const auto first_bright = counts.begin() + otsu_level(counts) + 1;
  const auto bright = std::find_if(first_bright, counts.end(), is_used);
  const auto dark = std::find_if(std::make_reverse_iterator(first_bright), counts.rend(), is_used);
  const auto brightest_dark = std::max<std::ptrdiff_t>(dark.base() - counts.begin() - 1, 0);
  const auto darkest_bright = std::min<std::ptrdiff_t>(bright - counts.begin(), 255);
  return std::clamp(static_cast<double>(brightest_dark + darkest_bright) / 2, 0.5, 254.5);
}

GrayImage threshold_silhouette(const GrayImage& image, const ThresholdOptions& options) {
  if (options.level && !(*options.level > 0 && *options.level < 255))
    throw UsageError("the level of a silhouette must be between 0 and 255");
  if (!(options.close >= 0 && options.close <= 1))
    throw UsageError("what is closed in a silhouette must be between 0 and 1 of the image");
  if (!(options.blur >= 0)) throw UsageError("the blur of a silhouette must not be negative");
  GrayImage silhouette = image;
  if (image.empty()) return silhouette;

  if (options.blur > 0) silhouette = gaussian_blur(image, options.blur);
  // Steep, but not so steep that the place of the contour between two pixels is lost.
  const auto level =
      static_cast<float>(options.level ? *options.level : dividing_level({&silhouette, 1}));
  const float slope = contour_level / std::min(level, 255 - level);
  for (float& pixel : silhouette.pixels)
    pixel = std::clamp(contour_level + slope * (pixel - level), 0.0F, 255.0F);
  const auto radius = static_cast<float>(options.close * std::max(image.width, image.height));
  return radius > 0 ? closed(silhouette, radius) : silhouette;
}

GrayImage two_levels(const GrayImage& silhouette) {
  GrayImage mask = silhouette;
  for (float& pixel : mask.pixels) pixel = is_inside(pixel) ? 255.0F : 0.0F;
  return mask;
}

double inside_share(const GrayImage& silhouette) {
  const auto inside = std::count_if(silhouette.pixels.begin(), silhouette.pixels.end(), is_inside);
  return silhouette.empty()
             ? 0.0
             : static_cast<double>(inside) / static_cast<double>(silhouette.pixels.size());
}

double silhouette_agreement(const GrayImage& first, const GrayImage& second) {
  if (first.width != second.width || first.height != second.height)
    throw UsageError("silhouettes of different sizes cannot be compared");
  std::size_t both = 0;
  std::size_t any = 0;
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    const bool is_in_first = is_inside(first.pixels[i]);
    const bool is_in_second = is_inside(second.pixels[i]);
    both += is_in_first && is_in_second ? 1 : 0;
    any += is_in_first || is_in_second ? 1 : 0;
  }
  return any == 0 ? 1.0 : static_cast<double>(both) / static_cast<double>(any);
}

GrayImage signed_distance(const GrayImage& silhouette) {
  return ContourDistance(silhouette).compute();
}

float distance_at(const GrayImage& distances, double x, double y) {
  const int width = distances.width;
  const int height = distances.height;
  if (!(x >= -0.5 && y >= -0.5 && x <= width - 0.5 && y <= height - 0.5)) return unknown_distance;
  const double inner_x = std::clamp(x, 0.0, width - 1.0);
  const double inner_y = std::clamp(y, 0.0, height - 1.0);
  const int left = std::min(static_cast<int>(inner_x), std::max(width - 2, 0));
  const int top = std::min(static_cast<int>(inner_y), std::max(height - 2, 0));
  const int right = std::min(left + 1, width - 1);
  const int bottom = std::min(top + 1, height - 1);

  const float upper_left = distances.at(left, top);
  if (std::isinf(upper_left)) return upper_left;  // and so are all others
  const auto across = static_cast<float>(inner_x - left);
  const auto down = static_cast<float>(inner_y - top);
  const float upper = upper_left + across * (distances.at(right, top) - upper_left);
  const float lower = distances.at(left, bottom) +
                      across * (distances.at(right, bottom) - distances.at(left, bottom));
  return upper + down * (lower - upper);
}

}  // namespace transformesh
