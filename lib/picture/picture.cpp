#include "picture/picture.h"

#include <algorithm>
#include <limits>
#include <string>

#include "mesh/local_measures.h"
#include "picture/colormap.h"
#include "picture/legend.h"
#include "picture/panels.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

bool has_column(const Mesh& mesh, const std::string& name) {
  return mesh.face_columns.find(name) != nullptr || mesh.vertex_columns.find(name) != nullptr;
}

bool has_numbers(const Mesh& mesh, const std::string& name) {
  return number_column_of_faces(mesh, name) != nullptr ||
         number_column_of_vertices(mesh, name) != nullptr;
}

/// Returns one scale for all meshes, so that their colors are comparable.
ColorScale find_scale(std::span<const Mesh* const> meshes, const PictureOptions& options) {
  const std::string& name = options.shade.color.by;
  if (options.range && name.empty())
    throw UsageError(ErrorKind::no_color_property,
                     "a range of colors needs a property to color by");
  if (name.empty()) return {};
  const bool is_there =
      std::ranges::any_of(meshes, [&](const Mesh* mesh) { return has_numbers(*mesh, name); });
  if (!options.range || !is_there) return scale_of_column(meshes, name);  // throws if none has it
  if (!(options.range->first < options.range->second))
    throw UsageError("the range of colors ends before it begins: LOW must be less than HIGH");
  return {options.range->first, options.range->second};
}

double lowest(std::span<const Mesh* const> meshes, const Vec3& upright) {
  double height = std::numeric_limits<double>::infinity();
  for (const Mesh* mesh : meshes)
    for (const Vec3& point : used_positions(*mesh)) height = std::min(height, upright.dot(point));
  return height;
}

/// Returns the height of the floor under a mesh. With Framing::place or PictureOptions::around, all
/// meshes have a common floor.
double floor_of(const Mesh* mesh, std::span<const Mesh* const> meshes,
                const PictureOptions& options, const Vec3& upright) {
  if (options.around != nullptr) return lowest({&options.around, 1}, upright);
  if (options.framing == Framing::place) return lowest(meshes, upright);
  return lowest({&mesh, 1}, upright);
}

/// Returns the options for one mesh, without columns that the mesh does not have.
ShadeOptions shading_of(const Mesh& mesh, const PictureOptions& options, bool can_highlight) {
  ShadeOptions shading = options.shade;
  shading.upright = eye_axes({0, 0, options.orbit.up, 1}).up;
  if (can_highlight && !has_column(mesh, shading.color.highlight)) shading.color.highlight.clear();
  if (!has_numbers(mesh, shading.color.by)) shading.color.by.clear();
  return shading;
}

}  // namespace

Mesh corners_around(std::span<const Mesh* const> meshes) {
  Box box;
  for (const Mesh* mesh : meshes)
    for (const Vec3& point : used_positions(*mesh)) box.extend(point);
  Mesh corners;
  for (const auto corner :
       {Box::BottomLeftFloor, Box::BottomRightFloor, Box::TopLeftFloor, Box::TopRightFloor,
        Box::BottomLeftCeil, Box::BottomRightCeil, Box::TopLeftCeil, Box::TopRightCeil})
    corners.positions.push_back(box.corner(corner));
  corners.faces = {{0, 1, 2}, {3, 4, 5}, {5, 6, 7}};
  return corners;
}

Image draw_picture(std::span<const Mesh* const> meshes, const PictureOptions& options,
                   const Progress& progress) {
  const bool has_legend = !options.shade.color.by.empty();
  const int strip = has_legend ? legend_height(options.width, options.height) : 0;
  const std::vector<Panel> panels = lay_out(meshes, options, strip);
  const std::string& highlight = options.shade.color.highlight;
  const bool can_highlight = std::any_of(
      meshes.begin(), meshes.end(), [&](const Mesh* mesh) { return has_column(*mesh, highlight); });

  const ColorScale scale = find_scale(meshes, options);

  Image whole(options.width, options.height);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    progress("draw", static_cast<double>(i) / static_cast<double>(panels.size()));
    const Panel& panel = panels[i];
    ShadeOptions shading = shading_of(*panel.mesh, options, can_highlight);
    shading.color.scale = scale;
    if (shading.soft_shadow) shading.floor = floor_of(panel.mesh, meshes, options, shading.upright);
    shade(*panel.mesh, panel.camera, shading, panel.x, panel.y, whole);
  }
  if (has_legend) draw_legend(scale, options.shade.background, whole);
  return whole;
}

}  // namespace transformesh
