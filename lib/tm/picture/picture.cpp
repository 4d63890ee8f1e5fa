#include "tm/picture/picture.h"

#include <algorithm>
#include <string>

#include "tm/mesh/measure.h"
#include "tm/picture/colormap.h"
#include "tm/picture/legend.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

constexpr long largest_side = 32768;
constexpr long most_pixels = 1L << 26;

/// A rectangle of the picture.
struct Panel {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

void check_size(const PictureOptions& options, int columns, int rows) {
  const auto text = std::to_string(options.width) + "x" + std::to_string(options.height);
  const long pixels = static_cast<long>(options.width) * options.height;
  if (options.width < 1 || options.height < 1 || options.width > largest_side ||
      options.height > largest_side || pixels > most_pixels)
    throw UsageError("a picture of " + text + " pixels: at most 32768 each way and 2^26 in all");
  if (columns > options.width || rows > options.height)
    throw UsageError("a picture of " + text + " pixels is too small for " +
                     std::to_string(columns) + "x" + std::to_string(rows) + " panels");
}

/// The borders of panels are the nearest whole pixels. The legend's strip is below them.
std::vector<Panel> layout(std::size_t count, const PictureOptions& options) {
  const int all = static_cast<int>(count);
  const int columns = options.columns > 0 ? std::min(options.columns, all) : all;
  const int rows = (all + columns - 1) / columns;
  check_size(options, columns, rows);
  const bool has_legend = !options.shade.color.by.empty();
  const int strip = has_legend ? legend_height(options.width, options.height) : 0;
  if (rows > options.height - strip)
    throw UsageError("the picture is too low for " + std::to_string(rows) +
                     " rows of panels above the legend");
  const auto border = [](int size, int i, int parts) {
    return static_cast<int>(static_cast<long>(size) * i / parts);
  };
  std::vector<Panel> panels;
  for (int i = 0; i < all; ++i) {
    const int column = i % columns;
    const int row = i / columns;
    const int x = border(options.width, column, columns);
    const int y = border(options.height - strip, row, rows);
    panels.push_back({x, y, border(options.width, column + 1, columns) - x,
                      border(options.height - strip, row + 1, rows) - y});
  }
  return panels;
}

std::vector<Vec3> used_points(std::span<const Mesh* const> meshes) {
  std::vector<Vec3> points;
  for (const Mesh* mesh : meshes) {
    const std::vector<Vec3> used = used_positions(*mesh);
    points.insert(points.end(), used.begin(), used.end());
  }
  return points;
}

/// The aim of each panel.
std::vector<Aim> find_aims(std::span<const Mesh* const> meshes, const std::vector<Panel>& panels,
                           const PictureOptions& options) {
  const auto aim_in = [&](const std::vector<Vec3>& points, const Panel& panel) {
    return aim_at(points, options.orbit, panel.width, panel.height);
  };
  std::vector<Aim> aims;
  if (options.around != nullptr || options.framing == Framing::place) {
    const std::vector<Vec3> points = options.around != nullptr
                                         ? used_points(std::span(&options.around, 1))
                                         : used_points(meshes);
    for (const Panel& panel : panels) aims.push_back(aim_in(points, panel));
    return aims;
  }
  for (std::size_t i = 0; i < meshes.size(); ++i)
    aims.push_back(aim_in(used_points(meshes.subspan(i, 1)), panels[i]));
  if (options.framing == Framing::scale) {
    double farthest = 0;
    for (const Aim& aim : aims) farthest = std::max(farthest, aim.distance);
    for (Aim& aim : aims) aim.distance = farthest;
  }
  return aims;
}

void check_meshes(std::span<const Mesh* const> meshes, const PictureOptions& options) {
  if (meshes.empty()) throw InputError("there is no mesh to draw");
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (meshes[i]->faces.empty())
      throw InputError("mesh " + std::to_string(i + 1) + " has no faces to draw");
  if (options.around != nullptr && options.around->faces.empty())
    throw InputError("the mesh to frame has no faces");
}

bool has_column(const Mesh& mesh, const std::string& name) {
  return mesh.face_columns.find(name) != nullptr || mesh.vertex_columns.find(name) != nullptr;
}

/// Of all meshes together, so that their colors compare.
ColorScale find_scale(std::span<const Mesh* const> meshes, const PictureOptions& options) {
  const std::string& name = options.shade.color.by;
  if (options.range && name.empty())
    throw UsageError("a range of colors needs a property to color by: --color-by");
  if (name.empty()) return {};
  const ColorScale own = scale_of_column(meshes, name);
  if (!options.range) return own;
  if (!(options.range->first < options.range->second))
    throw UsageError("the range of colors ends before it begins: LOW must be less than HIGH");
  return {options.range->first, options.range->second};
}

/// The options for one of the meshes, without what that one does not have.
ShadeOptions shading_of(const Mesh& mesh, const PictureOptions& options, bool can_highlight) {
  ShadeOptions shading = options.shade;
  shading.upright = eye_axes({0, 0, options.orbit.up, 1}).up;
  if (can_highlight && !has_column(mesh, shading.color.highlight)) shading.color.highlight.clear();
  if (number_column_of_faces(mesh, shading.color.by) == nullptr &&
      number_column_of_vertices(mesh, shading.color.by) == nullptr)
    shading.color.by.clear();
  return shading;
}

}  // namespace

Image draw_picture(std::span<const Mesh* const> meshes, const PictureOptions& options,
                   const Progress& progress) {
  check_meshes(meshes, options);
  const std::vector<Panel> panels = layout(meshes.size(), options);
  const std::vector<Aim> aims = find_aims(meshes, panels, options);
  const std::string& highlight = options.shade.color.highlight;
  const bool can_highlight = std::any_of(
      meshes.begin(), meshes.end(), [&](const Mesh* mesh) { return has_column(*mesh, highlight); });

  const ColorScale scale = find_scale(meshes, options);

  Image whole(options.width, options.height);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    progress("draw", static_cast<double>(i) / static_cast<double>(meshes.size()));
    ShadeOptions shading = shading_of(*meshes[i], options, can_highlight);
    shading.color.scale = scale;
    const Camera camera = orbit_camera(aims[i], options.orbit, panels[i].width, panels[i].height);
    shade(*meshes[i], camera, shading, panels[i].x, panels[i].y, whole);
  }
  if (!options.shade.color.by.empty()) draw_legend(scale, options.shade.background, whole);
  return whole;
}

}  // namespace transformesh
