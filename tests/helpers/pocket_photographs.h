/// Ray-traced photographs and depth maps of a textured block with a pocket that no silhouette
/// shows.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "helpers/view_maker.h"
#include "views/cameras/view.h"
#include "views/photo/solid_texture.h"

namespace transformesh::test {

/// The block is [-1, 1]^2 x [-0.7, 0.7]. The pocket is [-0.5, 0.5]^2 x [0.1, 0.7].
inline const Vec3 block_half(1, 1, 0.7);
inline constexpr double pocket_half = 0.5;
inline constexpr double pocket_floor = 0.1;
inline constexpr double pocket_volume = 1.0 * 1.0 * 0.6;
inline constexpr double block_volume = 2 * 2 * 1.4;

/// Returns the interval of ray parameters inside a box; empty if first > second.
inline std::pair<double, double> way_through(const Vec3& eye, const Vec3& ray, const Vec3& low,
                                             const Vec3& high) {
  double begin = -std::numeric_limits<double>::infinity();
  double end = -begin;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (low[axis] - eye[axis]) / ray[axis];
    const double b = (high[axis] - eye[axis]) / ray[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return {begin, end};
}

/// Returns the ray parameter at which the ray hits the block; 0 if it misses.
inline double way_to_block(const Vec3& eye, const Vec3& ray) {
  const auto [begin, end] = way_through(eye, ray, -block_half, block_half);
  if (!(begin < end)) return 0;
  const auto [open, floor] = way_through(eye, ray, Vec3(-pocket_half, -pocket_half, pocket_floor),
                                         Vec3(pocket_half, pocket_half, 100));
  if (open <= begin && floor > begin) return floor < end ? floor : 0;
  return begin;
}

struct PocketViews {
  std::vector<View> views;
  std::vector<GrayImage> depths;  ///< depth per pixel; 0 if the ray misses the block
};

/// Returns views from a ring of cameras. Every other camera faces the pocket, the rest the bottom.
inline PocketViews pocket_views(int count = 20) {
  const view_maker::Frame frame{160, 120, 430};
  const SolidTexture texture({.waves = 40, .finest = 0.15, .coarsest = 1});
  PocketViews result;
  for (int i = 0; i < count; ++i) {
    const double azimuth = 2 * std::numbers::pi * i / count;
    const double height = i % 2 == 0 ? 0.9 : -0.5;
    const Vec3 eye = 10 * Vec3(std::cos(height) * std::cos(azimuth),
                               std::cos(height) * std::sin(azimuth), std::sin(height));
    View view;
    view.name = "view" + std::to_string(i);
    view.camera = view_maker::camera_at(eye, frame);
    GrayImage image(frame.width, frame.height);
    GrayImage silhouette = image;
    GrayImage depth = image;
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const Vec3 ray = view.camera.ray(x, y);
        const double way = way_to_block(eye, ray);
        if (way == 0) continue;
        image.at(x, y) = texture.intensity_at(eye + way * ray);
        silhouette.at(x, y) = 255;
        depth.at(x, y) = static_cast<float>(way);
      }
    }
    view.image = std::move(image);
    view.silhouette = std::move(silhouette);
    result.views.push_back(std::move(view));
    result.depths.push_back(std::move(depth));
  }
  return result;
}

}  // namespace transformesh::test
