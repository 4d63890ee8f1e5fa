#include "views/color/color_vertices.h"

#include <algorithm>
#include <array>

#include "mesh/edges.h"
#include "mesh/local_measures.h"
#include "support/counted.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "views/cameras/view_files.h"
#include "views/color/exposure_compensation.h"
#include "views/color/surface_color_samples.h"

namespace transformesh {
namespace {

/// Surface points per parallel task; affects time only.
constexpr std::size_t places_per_task = 1024;
const Eigen::Array3f middle_gray = Eigen::Array3f::Constant(128);

/// Returns the two vertices of each edge, in the order of Edges.
std::vector<std::array<Index, 2>> neighbors(const Mesh& mesh) {
  const Edges edges(mesh);
  std::vector<std::array<Index, 2>> pairs;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Index halfedge = edges.halfedges(e)[0];
    pairs.push_back({halfedge_source(mesh, halfedge), halfedge_target(mesh, halfedge)});
  }
  return pairs;
}

/// Assigns colors to vertices that are not visible in any view, by propagation along edges. In each
/// round, a vertex without a color gets the mean color of its neighbors that already have one.
void fill_unseen(const Mesh& mesh, std::vector<char>& is_known,
                 std::vector<Eigen::Array3f>& colors) {
  std::vector<std::array<Index, 2>> pairs = neighbors(mesh);
  std::vector<Eigen::Array3f> sums(colors.size(), Eigen::Array3f::Zero());
  std::vector<float> counts(colors.size(), 0);
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    std::erase_if(pairs, [&](const auto& pair) { return is_known[pair[0]] && is_known[pair[1]]; });
    std::vector<Index> ring;
    for (const auto& [a, b] : pairs) {
      if (is_known[a] == is_known[b]) continue;
      const Index known = is_known[a] ? a : b;
      const Index other = is_known[a] ? b : a;
      if (counts[other] == 0) ring.push_back(other);
      sums[other] += colors[known];
      ++counts[other];
    }
    for (const Index v : ring) {
      colors[v] = sums[v] / counts[v];
      is_known[v] = 1;
      goes_on = true;
    }
  }
}

}  // namespace

double usual_pixel(const Mesh& mesh, std::span<const PictureView> views) {
  std::vector<PinholeCamera> cameras;
  for (const PictureView& view : views) cameras.push_back(view.camera);
  const Box box = bounding_box(mesh);
  return pixel_size(cameras, (box.min() + box.max()) / 2);
}

ColorSamples vertex_color_samples(const Mesh& mesh, std::span<const Vec3> normals) {
  const std::vector<double> edges = halfedge_lengths(mesh).vertex_mean;
  return {mesh.positions.size(),
          [&mesh, edges, normals](std::size_t v) {
            return Place{mesh.positions[v], normals[v], edges[v] / 2};
          },
          {}};
}

void sample_colors(const Mesh& mesh, std::span<const PictureView> views, double pixel,
                   std::span<ColorSamples* const> samples, const Progress& progress) {
  for (ColorSamples* const kind : samples) kind->seen.resize(kind->count);
  for (std::size_t i = 0; i < views.size(); ++i) {
    progress("look at photographs", static_cast<double>(i) / static_cast<double>(views.size()));
    const PhotographSampler picture(mesh, views[i].camera, views[i].picture(), pixel);
    for (ColorSamples* const kind : samples) {
      parallel_for(kind->count, places_per_task, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) kind->seen[k].add(picture.at(kind->place(k)), i);
      });
    }
  }
}

std::vector<Eigen::Array3f> vertex_colors(const Mesh& mesh, const ColorSamples& samples,
                                          std::span<const Gain> gains, ColorResult& result) {
  std::vector<Eigen::Array3f> colors(samples.count, middle_gray);
  std::vector<char> is_known(samples.count, 0);
  double differences = 0;
  for (std::size_t v = 0; v < samples.count; ++v) {
    if (!samples.seen[v].is_seen()) continue;
    colors[v] = samples.seen[v].blend(gains);
    differences += samples.seen[v].difference(colors[v], gains);
    is_known[v] = 1;
  }
  const auto seen = static_cast<std::size_t>(std::count(is_known.begin(), is_known.end(), 1));
  if (seen == 0)
    throw InputError(
        "the mesh is visible in no view: check that cameras, photographs and mesh "
        "belong to one scene and have the same units");
  result.unseen = samples.count - seen;
  result.largest_gain = largest_gain(gains);
  result.disagreement = differences / static_cast<double>(seen);
  fill_unseen(mesh, is_known, colors);
  return colors;
}

ColorResult color_vertices(Mesh& mesh, std::span<const PictureView> views,
                           const Progress& progress) {
  const std::vector<Vec3> normals = vertex_normals(mesh);
  ColorSamples vertices = vertex_color_samples(mesh, normals);
  const std::array<ColorSamples*, 1> samples{&vertices};
  sample_colors(mesh, views, usual_pixel(mesh, views), samples, progress);
  ColorResult result;
  const std::vector<Gain> gains = compensate_exposure(vertices.seen, views.size());
  const std::vector<Eigen::Array3f> colors = vertex_colors(mesh, vertices, gains, result);
  constexpr std::array names{"red", "green", "blue"};
  for (int channel = 0; channel < 3; ++channel) {
    const char* name = names.at(static_cast<std::size_t>(channel));
    Column& column = mesh.vertex_columns.get(name, Scalar::uint8, colors.size());
    for (std::size_t v = 0; v < colors.size(); ++v)
      column.values[v] = static_cast<std::uint8_t>(colors[v][channel] + 0.5F);
  }
  return result;
}

ColorResult color_vertices(Mesh& mesh, const ViewSources& sources, const Progress& progress) {
  return color_vertices(mesh, picture_views_from(sources), progress);
}

}  // namespace transformesh
