#include "views/color/texture_surface.h"

#include <algorithm>
#include <cmath>

#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "views/cameras/view_files.h"
#include "views/color/chart_packing.h"
#include "views/color/charts.h"
#include "views/color/exposure_compensation.h"
#include "views/color/surface_color_samples.h"
#include "views/color/texels.h"

namespace transformesh {
namespace {

/// Texels are enlarged by 10 % at a time until all charts fit into the largest texture. The search
/// is given up after this number of attempts.
constexpr int most_shrinkings = 60;

/// The point on the surface to which a texel belongs.
struct Texel {
  Index face = no_index;
  std::array<float, 2> weight{};  ///< barycentric weights of the face's corners 0 and 1

  template <class Values>
  auto mean_of(const Mesh& mesh, const Values& values) const {
    const Face& corners = mesh.faces[face];
    const double a = weight[0];
    const double b = weight[1];
    using Value = std::decay_t<decltype(values[0])>;
    using Number = typename Value::Scalar;
    return Value(static_cast<Number>(a) * values[corners[0]] +
                 static_cast<Number>(b) * values[corners[1]] +
                 static_cast<Number>(1 - a - b) * values[corners[2]]);
  }
};

struct Layout {
  std::vector<Chart> charts;
  Packing packing;
  double texel = 0;
};

void check(const AtlasOptions& options) {
  if (options.most_size < 16 || options.most_size > 32768)
    throw UsageError("a texture must have 16 to 32768 texels each way");
  if (options.padding < 1 || options.padding > 64)
    throw UsageError("the distance between charts of a texture must be 1 to 64 texels");
}

/// Returns the size of each chart in texels, rounded up, with padding on all sides.
std::vector<Eigen::Vector2i> boxes_of(const std::vector<Chart>& charts, double texel, int padding) {
  std::vector<Eigen::Vector2i> boxes;
  for (const Chart& chart : charts) {
    const Eigen::Vector2d texels = (chart.size / texel).array().ceil();
    boxes.emplace_back(texels.cast<int>() + Eigen::Vector2i::Constant(1 + 2 * padding));
  }
  return boxes;
}

bool could_fit(const std::vector<Chart>& charts, double texel, int most_size) {
  return std::all_of(charts.begin(), charts.end(),
                     [&](const Chart& chart) { return chart.size.maxCoeff() / texel < most_size; });
}

Layout lay_out(const Mesh& mesh, double texel, const AtlasOptions& options) {
  // `least` is approximately the smallest detail that a texture of the largest size can show. A
  // resolution of `least` / 4 suffices to find overlaps in charts. Finer grids would need more
  // memory.
  const double least = diagonal_of(bounding_box(mesh)) / options.most_size;
  Layout layout{make_charts(mesh, std::max(texel, least / 4)), {}, texel};
  for (int i = 0; i < most_shrinkings; ++i, layout.texel *= 1.1) {
    if (!could_fit(layout.charts, layout.texel, options.most_size)) continue;
    layout.packing = pack_boxes(boxes_of(layout.charts, layout.texel, options.padding));
    if (std::max(layout.packing.width, layout.packing.height) <= options.most_size) return layout;
  }
  throw GoalError(ErrorKind::texture_too_small,
                  "the texture does not fit in " + std::to_string(options.most_size) +
                      " texels each way: it has " + std::to_string(layout.charts.size()) +
                      " charts",
                  {.counts = {static_cast<std::size_t>(options.most_size), layout.charts.size()}});
}

/// Converts the corners of a face from chart coordinates to texture coordinates, in texels. The
/// center of the first texel is at 0.
std::array<Eigen::Vector2d, 3> in_texture(const std::array<Eigen::Vector2d, 3>& corners,
                                          const Eigen::Vector2i& place, double texel, int padding) {
  std::array<Eigen::Vector2d, 3> result;
  const Eigen::Vector2d start = place.cast<double>() + Eigen::Vector2d::Constant(padding);
  for (std::size_t i = 0; i < 3; ++i) result[i] = start + corners[i] / texel;
  return result;
}

/// Calls `action` with each face and its three corners in texture coordinates, chart by chart.
template <class Action>
void for_faces(const Layout& layout, int padding, const Action& action) {
  for (std::size_t c = 0; c < layout.charts.size(); ++c) {
    const Chart& chart = layout.charts[c];
    for (std::size_t i = 0; i < chart.faces.size(); ++i)
      action(chart.faces[i],
             in_texture(chart.corners[i], layout.packing.places[c], layout.texel, padding));
  }
}

Raster<Texel> texels_of(const Layout& layout, int padding) {
  Raster<Texel> texels(layout.packing.width, layout.packing.height);
  for_faces(layout, padding, [&](Index face, const std::array<Eigen::Vector2d, 3>& corners) {
    for_texels(corners, -1e-9, texels.width, texels.height,
               [&](int x, int y, const std::array<double, 3>& weights) {
                 Texel& texel = texels.at(x, y);
                 if (texel.face != no_index) return;
                 texel = {face, {static_cast<float>(weights[0]), static_cast<float>(weights[1])}};
               });
  });
  return texels;
}

void write_coordinates(const Layout& layout, int padding, Mesh& mesh) {
  Column& column = mesh.face_columns.get("texcoord", Scalar::float32, 0);
  column.list_count_type = Scalar::uint8;
  column.list_offsets.resize(mesh.faces.size() + 1);
  for (std::size_t f = 0; f <= mesh.faces.size(); ++f) column.list_offsets[f] = 6 * f;
  column.values.assign(6 * mesh.faces.size(), 0);
  for_faces(layout, padding, [&](Index face, const std::array<Eigen::Vector2d, 3>& corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      double* value = &column.values[6 * std::size_t{face} + 2 * i];
      value[0] = static_cast<float>((corners[i].x() + 0.5) / layout.packing.width);
      value[1] = static_cast<float>(1 - (corners[i].y() + 0.5) / layout.packing.height);
    }
  });
  for (const char* name : {"red", "green", "blue", "alpha"}) mesh.vertex_columns.erase(name);
}

Pixel pixel_of(const Eigen::Array3f& color) {
  return {static_cast<std::uint8_t>(color[0] + 0.5F), static_cast<std::uint8_t>(color[1] + 0.5F),
          static_cast<std::uint8_t>(color[2] + 0.5F), 255};
}

/// Extends the colors of charts to texels around them. Texels with alpha 0 have no color yet. Each
/// round colors those that have a colored neighbor.
void spread(Image& picture, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    const Image before = picture;
    const auto rows = static_cast<std::size_t>(picture.height);
    parallel_for(rows, 8, [&](std::size_t first, std::size_t last) {
      for (int y = static_cast<int>(first); y < static_cast<int>(last); ++y) {
        for (int x = 0; x < picture.width; ++x) {
          if (before.at(x, y)[3] != 0) continue;
          Eigen::Array3f sum = Eigen::Array3f::Zero();
          int count = 0;
          for (int j = std::max(y - 1, 0); j <= std::min(y + 1, picture.height - 1); ++j) {
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, picture.width - 1); ++i) {
              const Pixel& other = before.at(i, j);
              if (other[3] == 0) continue;
              sum += Eigen::Array3f(other[0], other[1], other[2]);
              ++count;
            }
          }
          if (count > 0) picture.at(x, y) = pixel_of(sum / static_cast<float>(count));
        }
      }
    });
  }
}

/// Sets the texels that have no color yet, far from all charts, to the mean color.
void fill_rest(Image& picture) {
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  double count = 0;
  for (const Pixel& pixel : picture.pixels) {
    if (pixel[3] == 0) continue;
    sum += Eigen::Array3d(pixel[0], pixel[1], pixel[2]);
    ++count;
  }
  const Pixel mean = pixel_of((sum / std::max(count, 1.0)).cast<float>());
  for (Pixel& pixel : picture.pixels)
    if (pixel[3] == 0) pixel = mean;
}

ColorSamples looks_at_texels(const Mesh& mesh, const std::vector<Vec3>& normals,
                             const Raster<Texel>& texels, double spacing) {
  return {texels.pixels.size(),
          [&mesh, &normals, &texels, spacing](std::size_t i) {
            const Texel& texel = texels.pixels[i];
            if (texel.face == no_index) return Place{Vec3::Zero(), Vec3::Zero(), 0};
            const Vec3 normal = texel.mean_of(mesh, normals);
            return Place{texel.mean_of(mesh, mesh.positions), normal.stableNormalized(), spacing};
          },
          {}};
}

}  // namespace

Atlas texture_surface(Mesh& mesh, std::span<const PictureView> views, const AtlasOptions& options,
                      const Progress& progress) {
  check(options);
  const double pixel = usual_pixel(mesh, views);
  progress("make charts");
  const Layout layout = lay_out(mesh, pixel, options);
  const Raster<Texel> texels = texels_of(layout, options.padding);

  // Sample colors at vertices, too: they are used for texels that are not visible in any view.
  const std::vector<Vec3> normals = vertex_normals(mesh);
  ColorSamples at_vertices = vertex_color_samples(mesh, normals);
  ColorSamples at_texels = looks_at_texels(mesh, normals, texels, layout.texel);
  const std::array<ColorSamples*, 2> samples{&at_vertices, &at_texels};
  sample_colors(mesh, views, pixel, samples, progress);
  Atlas atlas{Image(texels.width, texels.height, Pixel{}), layout.charts.size(), layout.texel, {}};
  const std::vector<Gain> gains = compensate_exposure(at_vertices.seen, views.size());
  const std::vector<Eigen::Array3f> colors = vertex_colors(mesh, at_vertices, gains, atlas.color);

  progress("paint");
  parallel_for(texels.pixels.size(), 4096, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Texel& texel = texels.pixels[i];
      if (texel.face == no_index) continue;
      const BestViewColors& seen = at_texels.seen[i];
      atlas.picture.pixels[i] =
          pixel_of(seen.is_seen() ? seen.blend(gains) : texel.mean_of(mesh, colors));
    }
  });
  spread(atlas.picture, options.padding);
  fill_rest(atlas.picture);
  write_coordinates(layout, options.padding, mesh);
  return atlas;
}

Atlas texture_surface(Mesh& mesh, const ViewSources& sources, const AtlasOptions& options,
                      const Progress& progress) {
  return texture_surface(mesh, picture_views_from(sources), options, progress);
}

}  // namespace transformesh
