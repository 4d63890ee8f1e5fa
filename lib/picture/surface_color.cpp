#include "picture/surface_color.h"

#include "mesh/color_scale.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

const Color default_front = color_of_srgb(0.66, 0.75, 0.86);
const Color back = color_of_srgb(0.66, 0.30, 0.30);
const Color highlighted = color_of_srgb(0.98, 0.60, 0.10);

/// Returns one color per row; empty if a channel is missing.
std::vector<Color> colors_of(const Columns& columns, std::size_t rows) {
  const std::array<const Column*, 3> channels{columns.find("red"), columns.find("green"),
                                              columns.find("blue")};
  for (const Column* channel : channels)
    if (!is_number_column(channel)) return {};
  std::vector<Color> colors(rows);
  for (std::size_t row = 0; row < rows; ++row)
    for (int i = 0; i < 3; ++i) {
      const Column& channel = *channels[static_cast<std::size_t>(i)];
      colors[row][i] = light_of_srgb(channel.values[row] / full_intensity(channel.type));
    }
  return colors;
}

template <typename Value, typename Lookup>
Value interpolated(const Face& face, const FacePixel& pixel, const Lookup& lookup) {
  const float rest = 1 - pixel.weight[0] - pixel.weight[1];
  return pixel.weight[0] * lookup(face[0]) + pixel.weight[1] * lookup(face[1]) +
         rest * lookup(face[2]);
}

}  // namespace

SurfaceColor::SurfaceColor(const Mesh& mesh, const SurfaceColorOptions& options)
    : mesh_(&mesh), front_(options.front.value_or(default_front)), scale_(options.scale) {
  if (!options.front) {
    vertex_colors_ = colors_of(mesh.vertex_columns, mesh.positions.size());
    if (vertex_colors_.empty()) face_colors_ = colors_of(mesh.face_columns, mesh.faces.size());
  }
  if (!options.by.empty()) {
    face_values_ = number_column_of_faces(mesh, options.by);
    vertex_values_ = number_column_of_vertices(mesh, options.by);
    const Mesh* const only = &mesh;
    if (face_values_ == nullptr && vertex_values_ == nullptr)
      scale_of_column(std::span(&only, 1), options.by);  // throws UsageError
  }
  if (options.highlight.empty()) return;
  const Column* of_faces = mesh.face_columns.find(options.highlight);
  const Column* of_vertices = mesh.vertex_columns.find(options.highlight);
  if (is_number_column(of_faces))
    face_highlight_ = of_faces;
  else if (is_number_column(of_vertices))
    vertex_highlight_ = of_vertices;
  else
    throw UsageError("neither faces nor vertices have a property '" + options.highlight +
                     "' of numbers to highlight");
}

Color SurfaceColor::at(const FacePixel& pixel, bool is_front) const {
  const Face& face = mesh_->faces[pixel.face];
  if (face_highlight_ != nullptr && face_highlight_->values[pixel.face] != 0) return highlighted;
  if (vertex_highlight_ != nullptr) {
    const auto is_set = [&](Index v) { return vertex_highlight_->values[v] != 0 ? 1.0F : 0.0F; };
    if (interpolated<float>(face, pixel, is_set) > 0.5F) return highlighted;
  }

  Color color = front_;
  if (face_values_ != nullptr)
    color = scale_.at(face_values_->values[pixel.face]);
  else if (vertex_values_ != nullptr)
    color = scale_.at(
        interpolated<double>(face, pixel, [&](Index v) { return vertex_values_->values[v]; }));
  else if (!vertex_colors_.empty())
    color = interpolated<Color>(face, pixel, [&](Index v) { return vertex_colors_[v]; });
  else if (!face_colors_.empty())
    color = face_colors_[pixel.face];
  return is_front ? color : Color(0.2F * color + 0.8F * back);
}

}  // namespace transformesh
