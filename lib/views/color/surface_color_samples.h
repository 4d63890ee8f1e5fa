/// Samples the colors of many surface points, from one photograph after the other. Internal to
/// color_vertices and texture_surface.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "transformesh/control.h"
#include "views/cameras/view_files.h"
#include "views/color/color_vertices.h"
#include "views/color/photograph_sampler.h"

namespace transformesh {

/// Places of one kind with their samples. `place` is called by several threads.
struct ColorSamples {
  std::size_t count = 0;
  std::function<Place(std::size_t)> place;
  std::vector<BestViewColors> seen;  ///< one per place, after sample_colors()
};

/// Returns the length of a pixel's side at the center of the mesh. Throws InputError unless the
/// mesh is in front of at least one camera.
double usual_pixel(const Mesh& mesh, std::span<const PictureView> views);

/// Returns samples at vertices, with half the mean edge length as spacing. Keeps a reference to the
/// mesh.
ColorSamples vertex_color_samples(const Mesh& mesh, std::span<const Vec3> normals);

/// Fills `seen` of all `samples`.
void sample_colors(const Mesh& mesh, std::span<const PictureView> views, double pixel,
                   std::span<ColorSamples* const> samples, const Progress& progress);

/// Returns blended colors, corrected by the gains of all views. An unobserved vertex gets the mean
/// color of its neighbors that have one, or middle gray if there are none.
std::vector<Eigen::Array3f> vertex_colors(const Mesh& mesh, const ColorSamples& samples,
                                          std::span<const Gain> gains, ColorResult& result);

}  // namespace transformesh
