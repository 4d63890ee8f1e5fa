/// Color samples of many places of a surface, taken from one photograph after the other. Internal
/// to color_vertices and texture_surface.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "transformesh/control.h"
#include "views/cameras/view_files.h"
#include "views/color/color_vertices.h"
#include "views/color/photograph_sampler.h"

namespace transformesh {

/// Places of one kind, asked for by several threads, and what was seen at each.
struct ColorSamples {
  std::size_t count = 0;
  std::function<Place(std::size_t)> place;
  std::vector<BestViewColors> seen;  ///< as many, once look() is done
};

/// Throws InputError unless there is a view and the surface is before one.
double usual_pixel(const Mesh& mesh, std::span<const PictureView> views);

/// The vertices, each for half of the length of its edges. Keeps a reference to the mesh.
ColorSamples vertex_color_samples(const Mesh& mesh, std::span<const Vec3> normals);

/// Fills `seen` of both.
void sample_colors(const Mesh& mesh, std::span<const PictureView> views, double pixel,
                   std::span<ColorSamples* const> samples, const Progress& progress);

/// The blends, with the gains of all views; what no view sees takes the mean of its neighbors that
/// have a color, or middle gray where there is none.
std::vector<Eigen::Array3f> vertex_colors(const Mesh& mesh, const ColorSamples& samples,
                                          std::span<const Gain> gains, ColorResult& result);

}  // namespace transformesh
