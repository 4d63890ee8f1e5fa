/// Samples the colors of many surface points, from one photograph after the other. Used only by
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

/// A list of surface points, such as all vertices, with their colors in the views. `place` returns
/// a point; several threads call it.
struct ColorSamples {
  std::size_t count = 0;
  std::function<Place(std::size_t)> place;
  /// Colors of each point in its best views; set by sample_colors().
  std::vector<BestViewColors> seen;
};

/// Returns the side of a typical pixel, projected to the center of the mesh: the median over all
/// views, in input units. Throws InputError unless the mesh is in front of at least one camera.
double usual_pixel(const Mesh& mesh, std::span<const PictureView> views);

/// Returns the list of all vertices, with half the mean edge length as Place::spacing. Keeps a
/// reference to `mesh` and `normals`.
ColorSamples vertex_color_samples(const Mesh& mesh, std::span<const Vec3> normals);

/// Finds the best colors of all surface points, and stores them in ColorSamples::seen. Decodes one
/// photograph at a time. `pixel` is the result of usual_pixel().
void sample_colors(const Mesh& mesh, std::span<const PictureView> views, double pixel,
                   std::span<ColorSamples* const> samples, const Progress& progress);

/// Returns the color of each vertex, blended from its best views after exposure correction by
/// `gains`. A vertex that no view observes gets the mean color of those neighbors that have one. It
/// gets middle gray if no vertices of its component have a color.
std::vector<Eigen::Array3f> vertex_colors(const Mesh& mesh, const ColorSamples& samples,
                                          std::span<const Gain> gains, ColorResult& result);

}  // namespace transformesh
