#include "views/color/photograph_sampler.h"

#include <algorithm>
#include <cmath>

#include "raster/camera.h"
#include "raster/rasterize.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr int rows_per_band = 16;  ///< rows of pixels per parallel task; affects time only
/// Limits of differences of depth, in units of a pixel's side at that depth. Neighboring pixels
/// whose depths differ by more than `contour_step` show different parts of the surface. A point is
/// hidden if its depth differs from that of its pixel by more than `hidden_step`.
constexpr float contour_step = 8;
constexpr double hidden_step = 6;
/// Least cosine between normal and viewing direction of a usable point.
constexpr double least_facing = 0.1;
/// At this distance from a contour and beyond, in pixels, the contour does not reduce the quality.
constexpr int full_margin = 8;
constexpr std::uint8_t most_margin = 64;  ///< largest stored distance from a contour, in pixels

Raster<float> depths(const Mesh& mesh, const Camera& camera) {
  const BandRasterizer bands(mesh, camera, rows_per_band);
  Raster<float> result(camera.width, camera.height);
  parallel_for(bands.bands(), 1, [&](std::size_t first, std::size_t last) {
    std::vector<FacePixel> rows;
    for (std::size_t band = first; band < last; ++band) {
      const int start = static_cast<int>(band) * rows_per_band;
      const int end = std::min(start + rows_per_band, camera.height);
      rows.assign(static_cast<std::size_t>(rows_per_band * camera.width), {});
      bands.draw(band, rows.data());
      float* depth = result.row(start);
      for (std::size_t i = 0; i < static_cast<std::size_t>((end - start) * camera.width); ++i)
        depth[i] = rows[i].depth;
    }
  });
  return result;
}

bool is_contour(const Raster<float>& depth, int x, int y, float focal) {
  if (x == 0 || y == 0 || x == depth.width - 1 || y == depth.height - 1) return true;
  const float here = depth.at(x, y);
  const float step = contour_step * here / focal;
  return here == 0 || std::abs(depth.at(x - 1, y) - here) > step ||
         std::abs(depth.at(x + 1, y) - here) > step || std::abs(depth.at(x, y - 1) - here) > step ||
         std::abs(depth.at(x, y + 1) - here) > step;
}

/// Returns the chessboard distance of each pixel from the nearest contour: the number of steps
/// between pixels that share a side or a corner. Makes one pass down and one pass up through the
/// image.
Raster<std::uint8_t> margins(const Raster<float>& depth, float focal) {
  Raster<std::uint8_t> margin(depth.width, depth.height, 0);
  parallel_for(static_cast<std::size_t>(depth.height), 16, [&](std::size_t first, std::size_t end) {
    for (int y = static_cast<int>(first); y < static_cast<int>(end); ++y)
      for (int x = 0; x < depth.width; ++x)
        margin.at(x, y) = is_contour(depth, x, y, focal) ? std::uint8_t{0} : most_margin;
  });
  const auto take = [&](int x, int y, std::initializer_list<std::uint8_t> neighbors) {
    std::uint8_t& here = margin.at(x, y);
    here = std::min<std::uint8_t>(here, static_cast<std::uint8_t>(std::min(neighbors) + 1));
  };
  for (int y = 1; y + 1 < depth.height; ++y)
    for (int x = 1; x + 1 < depth.width; ++x)
      take(x, y,
           {margin.at(x - 1, y), margin.at(x - 1, y - 1), margin.at(x, y - 1),
            margin.at(x + 1, y - 1)});
  for (int y = depth.height - 2; y > 0; --y)
    for (int x = depth.width - 2; x > 0; --x)
      take(x, y,
           {margin.at(x + 1, y), margin.at(x + 1, y + 1), margin.at(x, y + 1),
            margin.at(x - 1, y + 1)});
  return margin;
}

/// Returns the image at half the width and height. Each pixel is the mean of four pixels; an odd
/// last row or column is dropped.
Image half_of(const Image& image) {
  Image half(image.width / 2, image.height / 2);
  parallel_for(static_cast<std::size_t>(half.height), 16, [&](std::size_t first, std::size_t end) {
    for (int y = static_cast<int>(first); y < static_cast<int>(end); ++y) {
      for (int x = 0; x < half.width; ++x) {
        for (std::size_t c = 0; c < 3; ++c) {
          const int sum = image.at(2 * x, 2 * y)[c] + image.at(2 * x + 1, 2 * y)[c] +
                          image.at(2 * x, 2 * y + 1)[c] + image.at(2 * x + 1, 2 * y + 1)[c];
          half.at(x, y)[c] = static_cast<std::uint8_t>((sum + 2) / 4);
        }
      }
    }
  });
  return half;
}

Eigen::Array3f intensities_at(const Image& image, int x, int y) {
  const Pixel& pixel = image.at(x, y);
  return {static_cast<float>(pixel[0]), static_cast<float>(pixel[1]), static_cast<float>(pixel[2])};
}

/// Returns the color at (x, y) by bilinear interpolation. Points outside of the rectangle of pixel
/// centers get the color at its border.
Eigen::Array3f interpolated(const Image& image, double x, double y) {
  x = std::clamp(x, 0.0, image.width - 1.0);
  y = std::clamp(y, 0.0, image.height - 1.0);
  const int left = static_cast<int>(x);
  const int top = static_cast<int>(y);
  const int right = std::min(left + 1, image.width - 1);
  const int bottom = std::min(top + 1, image.height - 1);
  const auto s = static_cast<float>(x - left);
  const auto t = static_cast<float>(y - top);
  return (1 - t) *
             ((1 - s) * intensities_at(image, left, top) + s * intensities_at(image, right, top)) +
         t * ((1 - s) * intensities_at(image, left, bottom) +
              s * intensities_at(image, right, bottom));
}

}  // namespace

PhotographSampler::PhotographSampler(const Mesh& mesh, const PinholeCamera& camera, Image picture,
                                     double pixel)
    : projection_(camera.projection()),
      center_(camera.center()),
      focal_(camera.focal_length()),
      pixel_(pixel),
      depth_(depths(mesh, {projection_, picture.width, picture.height})),
      margin_(margins(depth_, static_cast<float>(focal_))) {
  pyramid_.push_back(std::move(picture));
  for (int size = 2; size <= most_margin; size *= 2) {
    if (pyramid_.back().width < 2 || pyramid_.back().height < 2) break;
    pyramid_.push_back(half_of(pyramid_.back()));
  }
}

/// Returns the color at (x, y), interpolated between two levels of the image pyramid `pyramid_`.
/// The sides of their pixels are closest to `spacing`, but at most `margin`, the distance from the
/// nearest contour. Larger pixels would include colors from the other side of the contour.
Eigen::Array3f PhotographSampler::color_at(double x, double y, double spacing, int margin) const {
  const double size = std::min(spacing, static_cast<double>(margin));
  std::size_t octave = 0;
  double side = 1;
  for (; octave + 1 < pyramid_.size() && 2 * side <= size; side *= 2) ++octave;
  const auto at = [&](std::size_t i, double pixel) {
    return interpolated(pyramid_[i], (x + 0.5) / pixel - 0.5, (y + 0.5) / pixel - 0.5);
  };
  const Eigen::Array3f fine = at(octave, side);
  const auto share = static_cast<float>(std::clamp(size / side - 1, 0.0, 1.0));
  if (share == 0 || octave + 1 == pyramid_.size()) return fine;
  return (1 - share) * fine + share * at(octave + 1, 2 * side);
}

ViewColor PhotographSampler::at(const Place& place) const {
  const Vec3 q = projection_.leftCols<3>() * place.point + projection_.col(3);
  if (!(q.z() > 0)) return {};
  const double x = q.x() / q.z();
  const double y = q.y() / q.z();
  if (!(x >= 0 && y >= 0 && x <= depth_.width - 1 && y <= depth_.height - 1)) return {};
  const int column = static_cast<int>(x + 0.5);
  const int row = static_cast<int>(y + 0.5);
  const int margin = margin_.at(column, row);
  const double side = q.z() / focal_;
  if (margin == 0 || std::abs(depth_.at(column, row) - q.z()) > hidden_step * side) return {};
  const double facing = place.normal.dot((center_ - place.point).normalized());
  if (!(facing > least_facing)) return {};

  // The quality is multiplied by the eighth root of `share`. Blending weights are the 16th power of
  // the quality, and thus proportional to the square of the distance from the contour.
  const double share = std::min(1.0, static_cast<double>(margin) / full_margin);
  const double quality = facing * pixel_ / side * std::sqrt(std::sqrt(std::sqrt(share)));
  const Eigen::Array3f color = color_at(x, y, place.spacing / side, margin) + 0.5F;
  return {static_cast<float>(quality),
          {static_cast<std::uint8_t>(color[0]), static_cast<std::uint8_t>(color[1]),
           static_cast<std::uint8_t>(color[2])}};
}

}  // namespace transformesh
