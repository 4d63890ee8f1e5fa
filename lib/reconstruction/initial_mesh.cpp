#include "reconstruction/initial_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "evolution/loop/stages.h"
#include "io/document/round_as_written.h"
#include "raster/camera.h"
#include "reconstruction/image_scales.h"
#include "support/counted.h"
#include "support/parallel.h"
#include "transformesh/clean.h"
#include "transformesh/errors.h"
#include "transformesh/hull.h"
#include "transformesh/iteration.h"
#include "transformesh/manifold.h"
#include "transformesh/mesh_io.h"
#include "transformesh/pinhole_camera.h"
#include "views/cameras/view.h"
#include "views/depth/dense_surface.h"
#include "views/hull/agreed_threshold.h"
#include "views/hull/contour_distance.h"
#include "views/hull/hull_values.h"
#include "views/hull/needed_components.h"
#include "views/hull/silhouette.h"
#include "views/hull/view_check.h"

namespace transformesh {
namespace {

void find_silhouettes(std::vector<View>& views, const InitialMeshOptions& options,
                      const Progress& progress) {
  threshold_silhouettes(views, options.threshold.value_or(ThresholdOptions()), progress);
  check_views(views, {.least_agreement = options.least_agreement}, progress);
}

bool has_masks(const std::vector<View>& views) { return !views.front().silhouette.empty(); }

void append_mesh(Mesh& mesh, const Mesh& other) {
  const auto offset = static_cast<Index>(mesh.positions.size());
  mesh.vertex_columns.concatenate(other.vertex_columns, offset, other.positions.size());
  mesh.face_columns.concatenate(other.face_columns, mesh.faces.size(), other.faces.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& [a, b, c] : other.faces)
    mesh.faces.push_back({a + offset, b + offset, c + offset});
}

// Returns true if the mesh is projected into the mask, up to a tolerance. Projections outside of
// the image count as outside of the mask.
bool is_within_mask(const Mesh& mesh, const View& view) {
  // Tolerance in pixels. Contours of masks without intermediate intensities have errors of up to a
  // pixel.
  constexpr double most_outside_px = 1;
  // Limit up to which distances from the mask are computed; must exceed `most_outside_px`.
  constexpr float limit_px = 4;
  const GrayImage distances = signed_distance(view.silhouette.unpacked(), limit_px);
  const Projection projection = view.camera.projection();
  return std::all_of(mesh.positions.begin(), mesh.positions.end(), [&](const Vec3& position) {
    const Vec3 q = projection.leftCols<3>() * position + projection.col(3);
    return q.z() > 0 && distance_at(distances, q.x() / q.z(), q.y() / q.z()) <= most_outside_px;
  });
}

bool is_within_masks(const Mesh& mesh, const std::vector<View>& views) {
  std::vector<char> is_within(views.size(), 1);
  parallel_for(views.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      if (!views[i].silhouette.empty()) is_within[i] = is_within_mask(mesh, views[i]) ? 1 : 0;
  });
  return std::find(is_within.begin(), is_within.end(), 0) == is_within.end();
}

// Replaces the mesh by its exact intersection with the hull.
void clip(Document& document, const Mesh& hull, const std::string& name, const Progress& progress) {
  append_mesh(document.mesh, hull);
  document.style.coordinate = Scalar::float64;
  try {
    document.mesh = clean(document.mesh, {.winding_level = 2, .outermost = true}, progress).mesh;
  } catch (const GoalError&) {
    throw GoalError(ErrorKind::outside_hull,
                    "'" + name + "' lies outside the hull of the silhouettes", {.name = name});
  }
  round_as_written(document);
}

/// Returns the edge length of the hull's grid cells, enlarged until the box contains at most
/// `most_cells`. The hull is coarsened later anyway.
double affordable(double edge, const Box& box) {
  constexpr double most_cells = 1 << 26;  // chosen by hand, to limit memory
  const Vec3 size = box.max() - box.min();
  while (size.prod() > most_cells * edge * edge * edge) edge *= 1.25;
  return edge;
}

/// Bounding rectangle of points in an image.
struct Rectangle {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(HUGE_VAL);
  Eigen::Vector2d high = Eigen::Vector2d::Constant(-HUGE_VAL);

  void add(const Eigen::Vector2d& place) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
};

void add_silhouette(const PackableImage& silhouette, Rectangle& rectangle) {
  for (int y = 0; y < silhouette.height; ++y)
    for (int x = 0; x < silhouette.width; ++x)
      if (silhouette.at(x, y) > contour_intensity) rectangle.add({x, y});
}

/// Returns the view cropped to the mesh and the silhouette, with a margin so that the surface can
/// move.
View around(const Mesh& mesh, const View& view) {
  // The margin is the sum of this number of pixels and a fraction of the cropped size. A larger
  // margin leaves more room for the surface but takes more memory.
  constexpr double margin_px = 32;
  constexpr double margin_share = 0.05;
  Rectangle rectangle;
  const Projection projection = view.camera.projection();
  for (const Vec3& position : mesh.positions) {
    const Vec3 q = projection.leftCols<3>() * position + projection.col(3);
    if (!(q.z() > 0)) return view;
    rectangle.add(q.hnormalized());
  }
  add_silhouette(view.silhouette, rectangle);
  if (!(rectangle.low.array() <= rectangle.high.array()).all()) return view;
  const double margin = margin_px + margin_share * (rectangle.high - rectangle.low).maxCoeff();
  const auto clamped = [](double value, int size) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(size)));
  };
  const int left = clamped(rectangle.low.x() - margin, view.image.width);
  const int top = clamped(rectangle.low.y() - margin, view.image.height);
  const int right = clamped(rectangle.high.x() + margin + 1, view.image.width);
  const int bottom = clamped(rectangle.high.y() + margin + 1, view.image.height);
  if (left >= right || top >= bottom) return view;
  return cropped(view, left, top, right - left, bottom - top);
}

Mesh hull_of_silhouettes(std::vector<View>& views, const InitialMeshOptions& options,
                         std::optional<double> edge, const Progress& progress) {
  HullOptions hull;
  hull.box = silhouette_box(views);
  if (edge) hull.edge = affordable(*edge, *hull.box);
  hull.keep = options.keep.value_or(0);
  Mesh mesh = visual_hull(views, hull, progress).mesh;
  if (!options.keep) drop_unneeded_components(mesh, views);
  return mesh;
}

/// Makes `document` the hull of thresholded silhouettes and returns "". If this fails, removes the
/// silhouettes and returns the reason. Rethrows the error if a threshold was given. Also rethrows
/// errors of find_silhouettes() other than ErrorKind::views_disagree.
std::string reason_against_hull(Document& document, std::vector<View>& views,
                                const InitialMeshOptions& options, double edge,
                                const Progress& progress) {
  bool are_checked = false;
  try {
    find_silhouettes(views, options, progress);
    are_checked = true;
    document.mesh = hull_of_silhouettes(views, options, edge, progress);
    return {};
  } catch (const InputError& error) {
    const bool is_mistake = !are_checked && error.kind() != ErrorKind::views_disagree;
    if (options.threshold || is_mistake) throw;
    for (View& view : views) view.silhouette = PackableImage();
    return error.what();
  }
}

/// Makes the hull of thresholded silhouettes. If there is no such hull, as for photographs of an
/// object on a table, makes a surface from depth maps.
InitialMesh make_without_masks(Document& document, std::vector<View>& views,
                               const InitialMeshOptions& options, double edge,
                               const Progress& progress) {
  InitialMesh made;
  const std::string reason = reason_against_hull(document, views, options, edge, progress);
  if (reason.empty()) {
    made.outlined = document.mesh;
    return made;
  }
  DenseSurface dense = dense_surface(views, {}, progress);
  made.why_dense = "without masks there is no hull (" + reason +
                   "); the initial mesh is made from depth maps, with " +
                   counted(dense.consistent, "consistent pixel") + " of " +
                   std::to_string(dense.pixels);
  document.mesh = std::move(dense.mesh);
  document.style.coordinate = Scalar::float64;
  document.style.format = Format::ply_little;
  clean_in_place(document, progress);
  return made;
}

}  // namespace

double pixel_size(const std::vector<View>& views) {
  const std::vector<PinholeCamera> cameras = cameras_of(views);
  return pixel_size(cameras, viewed_point(cameras));
}

Mesh hull_of(std::vector<View>& views, const InitialMeshOptions& options,
             std::optional<double> edge, const Progress& progress) {
  if (!has_masks(views)) find_silhouettes(views, options, progress);
  return hull_of_silhouettes(views, options, edge, progress);
}

void outline(std::vector<View>& views, const Mesh& mesh) {
  for (View& view : views) {
    const bool is_packed = view.image.is_packed();
    view.silhouette = mesh_silhouette(mesh, view);
    if (is_packed) view.silhouette.pack();
    if (inside_share(view.silhouette) == 0)
      throw InputError(view.name + ": the visual hull is outside this view");
  }
}

InitialMesh make_initial_mesh(Document& document, std::vector<View>& views,
                              const InitialMeshOptions& options, double pixel,
                              const Progress& progress) {
  const bool are_masks = has_masks(views);
  const double edge = edge_times(3, pixel);
  if (!options.is_given && !are_masks)
    return make_without_masks(document, views, options, edge, progress);
  InitialMesh made;
  if (!options.is_given) {
    document.mesh = hull_of(views, options, edge, progress);
    return made;
  }
  document.style.format = Format::ply_little;
  clean_in_place(document, progress);
  const bool is_closed = check_manifold(document.mesh).is_closed();
  if (are_masks && options.meaning == SilhouetteMeaning::exact && options.clips_by_hull &&
      !(is_closed && is_within_masks(document.mesh, views))) {
    InitialMeshOptions all = options;
    all.keep = 0;
    if (is_closed) made.unclipped = document;
    clip(document, hull_of(views, all, edge, progress), options.name, progress);
  }
  if (!are_masks && options.threshold) made.outlined = hull_of(views, options, edge, progress);
  return made;
}

void crop_views(std::vector<View>& views, const Mesh& mesh) {
  parallel_for(views.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      if (views[i].image.is_packed()) views[i] = around(mesh, views[i]);
  });
}

}  // namespace transformesh
