#include "tm/evolution/reconstruction_start.h"

#include "tm/clean/clean.h"
#include "tm/evolution/iteration.h"
#include "tm/evolution/scales.h"
#include "tm/io/mesh_io.h"
#include "tm/support/error.h"
#include "tm/views/cameras/pinhole_camera.h"
#include "tm/views/hull/agreed_level.h"
#include "tm/views/hull/hull.h"
#include "tm/views/hull/silhouette.h"
#include "tm/views/hull/view_check.h"

namespace transformesh {
namespace {

bool has_masks(const std::vector<View>& views) { return !views.front().silhouette.empty(); }

void append(Mesh& mesh, const Mesh& other) {
  const auto offset = static_cast<Index>(mesh.positions.size());
  mesh.vertex_columns.concatenate(other.vertex_columns, offset, other.positions.size());
  mesh.face_columns.concatenate(other.face_columns, mesh.faces.size(), other.faces.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& [a, b, c] : other.faces)
    mesh.faces.push_back({a + offset, b + offset, c + offset});
}

// The exact intersection of both.
void clip(Document& document, const Mesh& hull, const std::string& name, const Progress& progress) {
  append(document.mesh, hull);
  document.style.coordinate = Scalar::float64;
  try {
    document.mesh = clean(document.mesh, {.level = 2, .outermost = true}, progress).mesh;
  } catch (const GoalError&) {
    throw GoalError("nothing of '" + name + "' is within the hull of the silhouettes; see --clip");
  }
  round_as_written(document);
}

}  // namespace

double pixel_size(const std::vector<View>& views) {
  const std::vector<PinholeCamera> cameras = cameras_of(views);
  return pixel_size(cameras, viewed_point(cameras));
}

Mesh hull_of(std::vector<View>& views, const StartOptions& options, std::optional<double> edge,
             const Progress& progress) {
  if (!has_masks(views)) {
    threshold_silhouettes(views, options.threshold.value_or(ThresholdOptions()), progress);
    check_views(views, {.least_agreement = options.least_agreement}, progress);
  }
  HullOptions hull;
  hull.box = silhouette_box(views);
  hull.edge = edge;
  hull.keep = options.keep;
  return visual_hull(views, hull, progress).mesh;
}

void outline(std::vector<View>& views, const Mesh& mesh) {
  for (View& view : views) {
    view.silhouette = mesh_silhouette(mesh, view);
    if (inside_share(view.silhouette) == 0)
      throw InputError(view.name + ": nothing of the visual hull is in this view");
  }
}

std::optional<Mesh> begin_surface(Document& document, std::vector<View>& views,
                                  const StartOptions& options, double pixel,
                                  const Progress& progress) {
  const bool are_masks = has_masks(views);
  const double edge = edge_times(3, pixel);
  if (!options.is_given) {
    document.mesh = hull_of(views, options, edge, progress);
    return are_masks ? std::nullopt : std::optional(document.mesh);
  }
  document.style.format = Format::ply_little;
  clean_in_place(document, progress);
  if (are_masks && options.meaning == SilhouetteMeaning::exact && options.clips_by_hull) {
    StartOptions all = options;
    all.keep = 0;
    clip(document, hull_of(views, all, edge, progress), options.name, progress);
  }
  if (are_masks || !options.threshold) return std::nullopt;
  return hull_of(views, options, edge, progress);
}

}  // namespace transformesh
