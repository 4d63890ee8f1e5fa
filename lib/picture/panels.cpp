#include "picture/panels.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "mesh/local_measures.h"
#include "raster/camera.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

constexpr long largest_side = 32768;    ///< pixels; chosen by hand, to limit memory
constexpr long most_pixels = 1L << 26;  ///< pixels; chosen by hand, to limit memory

void check_meshes(std::span<const Mesh* const> meshes, const PictureOptions& options) {
  if (meshes.empty()) throw InputError("there is no mesh to draw");
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (meshes[i]->faces.empty())
      throw InputError("mesh " + std::to_string(i + 1) + " has no faces to draw");
  if (options.around != nullptr && options.around->faces.empty())
    throw InputError("the mesh to frame has no faces");
  if (options.only && *options.only >= meshes.size())
    throw UsageError("the picture shows mesh " + std::to_string(*options.only + 1) + " of " +
                     std::to_string(meshes.size()));
}

/// Returns the number of meshes that are drawn.
std::size_t drawn(std::span<const Mesh* const> meshes, const PictureOptions& options) {
  return options.only ? 1 : meshes.size();
}

void check_turn(const PictureOptions& options) {
  if (options.views < 1 || options.frames < 1)
    throw UsageError("a movie around a mesh needs at least one view and one frame");
}

void check_size(const PictureOptions& options, int columns, int rows, int strip) {
  const auto text = std::to_string(options.width) + "x" + std::to_string(options.height);
  const long pixels = static_cast<long>(options.width) * options.height;
  if (options.width < 1 || options.height < 1 || options.width > largest_side ||
      options.height > largest_side || pixels > most_pixels)
    throw UsageError("a picture of " + text +
                     " pixels is not supported: use 1 to 32768 each way, and at most 2^26 in all");
  if (columns > options.width || rows > options.height)
    throw UsageError("a picture of " + text + " pixels is too small for " +
                     std::to_string(columns) + "x" + std::to_string(rows) + " panels");
  if (rows > options.height - strip)
    throw UsageError("the picture is not high enough for " + std::to_string(rows) +
                     " rows of panels above the legend");
}

int rows_of(int panels, int columns) { return (panels + columns - 1) / columns; }

/// Returns the number of columns with the largest panels (by their shorter side); if there are
/// several, the one with fewest empty panels.
int largest_panels(int panels, int width, int height) {
  const auto quality = [&](int columns) {
    const int rows = rows_of(panels, columns);
    return std::tuple(std::min(width / columns, height / rows), panels - columns * rows);
  };
  int best = 1;
  for (int columns = 2; columns <= panels; ++columns)
    if (quality(columns) > quality(best)) best = columns;
  return best;
}

int columns_of(std::size_t meshes, const PictureOptions& options, int strip) {
  const int all = static_cast<int>(meshes) * options.views;
  if (options.columns > 0) return std::min(options.columns, all);
  if (options.views == 1) return all;
  if (meshes > 1) return options.views;
  return largest_panels(all, options.width, options.height - strip);
}

/// Returns the panels in reading order. Their meshes are not yet set.
std::vector<Panel> divide(std::size_t meshes, const PictureOptions& options, int strip) {
  const int all = static_cast<int>(meshes) * options.views;
  const int columns = columns_of(meshes, options, strip);
  const int rows = rows_of(all, columns);
  check_size(options, columns, rows, strip);
  const auto border = [](int size, int i, int parts) {
    return static_cast<int>(static_cast<long>(size) * i / parts);
  };
  std::vector<Panel> panels(static_cast<std::size_t>(all));
  for (int i = 0; i < all; ++i) {
    const int column = i % columns;
    const int row = i / columns;
    Panel& panel = panels[static_cast<std::size_t>(i)];
    panel.x = border(options.width, column, columns);
    panel.y = border(options.height - strip, row, rows);
    panel.camera.width = border(options.width, column + 1, columns) - panel.x;
    panel.camera.height = border(options.height - strip, row + 1, rows) - panel.y;
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

std::vector<Aim> find_aims(std::span<const Mesh* const> meshes, const std::vector<Panel>& panels,
                           const PictureOptions& options) {
  const bool is_turning = options.views > 1 || options.frames > 1;
  const auto aim_in = [&](const std::vector<Vec3>& points, const Camera& camera) {
    return (is_turning ? turn_aim : aim_at)(points, options.orbit, camera.width, camera.height);
  };
  std::vector<Aim> aims;
  if (options.around != nullptr || options.framing == Framing::place) {
    const std::vector<Vec3> points = options.around != nullptr
                                         ? used_points(std::span(&options.around, 1))
                                         : used_points(meshes);
    for (const Panel& panel : panels) aims.push_back(aim_in(points, panel.camera));
    return aims;
  }
  for (const Panel& panel : panels)
    aims.push_back(aim_in(used_points(std::span(&panel.mesh, 1)), panel.camera));
  if (options.framing == Framing::scale) {
    double farthest = 0;
    for (const Aim& aim : aims) farthest = std::max(farthest, aim.distance);
    for (Aim& aim : aims) aim.distance = farthest;
  }
  return aims;
}

}  // namespace

std::vector<Panel> lay_out(std::span<const Mesh* const> meshes, const PictureOptions& options,
                           int strip) {
  check_meshes(meshes, options);
  check_turn(options);
  std::vector<Panel> panels = divide(drawn(meshes, options), options, strip);
  const auto views = static_cast<std::size_t>(options.views);
  for (std::size_t i = 0; i < panels.size(); ++i)
    panels[i].mesh = meshes[options.only ? *options.only : i / views];

  const std::vector<Aim> aims = find_aims(meshes, panels, options);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    Orbit orbit = options.orbit;
    orbit.azimuth_deg += 360.0 * static_cast<double>(i % views) / options.views +
                         360.0 * options.frame / options.frames;
    Camera& camera = panels[i].camera;
    camera = orbit_camera(aims[i], orbit, camera.width, camera.height);
  }
  return panels;
}

}  // namespace transformesh
