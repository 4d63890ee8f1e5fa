#include "transformesh/remesh.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "geometry/search/closest_point.h"
#include "mesh/surface_columns.h"
#include "remesh/check_remesh_options.h"
#include "remesh/guards/edge_rules.h"
#include "remesh/halfedges/halfedges.h"
#include "remesh/halfedges/sharpness.h"
#include "remesh/operations/bilaplacian_smoothing.h"
#include "remesh/operations/collapse.h"
#include "remesh/operations/curved_split.h"
#include "remesh/operations/degenerate.h"
#include "remesh/operations/flip.h"
#include "remesh/operations/high_valence_collapse.h"
#include "remesh/operations/safe_split.h"
#include "remesh/operations/slivers.h"
#include "remesh/operations/smooth.h"
#include "remesh/pinch.h"
#include "remesh/remesh_connected.h"
#include "remesh/sizing.h"
#include "remesh/small_components.h"
#include "remesh/thin_components.h"
#include "support/counted.h"
#include "support/empty_result_error.h"
#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

constexpr double most_faces = 500e6;  ///< largest number of faces; chosen by hand, to limit memory
/// Largest extent at which squares of areas are below the largest double.
constexpr double largest_extent = 1e75;
/// If edges are far too short, they are collapsed in stages. Each stage collapses edges shorter
/// than this multiple of the typical length.
constexpr double stage_growth = 1.6;
/// Edges shorter or longer than these shares of the edge length for the local curvature (sizing.h)
/// are collapsed or split. `adaptive_longest` is below 1, because faces relax after splits and
/// curvature varies: longer edges would exceed the error.
constexpr double adaptive_shortest = 0.55;
constexpr double adaptive_longest = 0.95;
/// If remesh() does at least this number of iterations, it calls smooth_bilaplacian() at the end,
/// which moves vertices nearer to a smooth surface. Calls with fewer iterations are usually steps
/// of an evolution, which need no smoothing.
constexpr int iterations_anew = 3;
constexpr double usual_feature_angle_deg = 40;
/// If RemeshOptions::curved is set, a new vertex leaves its edge by up to a fifth of the length,
/// which makes edges longer by up to this factor. The guard allows such edges. Without the factor,
/// the new vertices of the longest edges would stay on the straight edge.
constexpr double lifted_edge = 1.05;

/// Throws InputError if fourth powers of lengths, from which areas are computed, could overflow.
void check_size(const Mesh& mesh) {
  Vec3 lowest = mesh.positions[0];
  Vec3 highest = lowest;
  for (const Vec3& position : mesh.positions) {
    lowest = lowest.cwiseMin(position);
    highest = highest.cwiseMax(position);
  }
  const double size = (highest - lowest).maxCoeff();
  if (!(size <= largest_extent)) {
    throw InputError("the mesh is " + shortest_text(size) +
                     " across, too large to compute its areas: scale it to less than " +
                     shortest_text(largest_extent));
  }
}

RemeshOptions with_feature_angle(RemeshOptions options, const EditableMesh& mesh) {
  if (options.feature_angle_deg == 0)
    options.feature_angle_deg = has_sharp_edges(mesh) ? usual_feature_angle_deg : 180;
  return options;
}

EdgeLimits set_sizes(EditableMesh& mesh, const Mesh& input, const RemeshOptions& options) {
  EdgeLimits limits{options.min_edge, options.max_edge, {options.curved, options.min_film}};
  std::vector<double> sizes;
  if (!options.size_column.empty()) {
    sizes = sizes_of_column(input, options.size_column);
  } else if (options.adaptive_error > 0) {
    limits.shortest = adaptive_shortest;
    limits.longest = adaptive_longest;
    const double most = options.max_edge / adaptive_longest;
    const double least = std::min(options.min_edge / adaptive_shortest, most);
    mark_features(mesh, options.feature_angle_deg);
    sizes = sizes_of_curvature(mesh, {options.adaptive_error, least, most});
  }
  if (sizes.empty()) return limits;
  grade_sizes(mesh, sizes);
  mesh.set_sizes(std::move(sizes));
  return limits;
}

struct SizeRange {
  double smallest = 1;
  double largest = 1;
};

SizeRange sizes_of(const EditableMesh& mesh) {
  if (!mesh.has_sizes()) return {};
  SizeRange range{HUGE_VAL, 0};
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    if (!mesh.has_vertex(v)) continue;
    range.smallest = std::min(range.smallest, mesh.size(v));
    range.largest = std::max(range.largest, mesh.size(v));
  }
  return range;
}

/// Returns true if there are degenerate faces. Throws UsageError if edges of length `max_edge`
/// would take too many faces.
bool survey_faces(const EditableMesh& mesh, double max_edge) {
  double faces = 0;
  bool has_degenerate = false;
  for (Index face = 0; face < mesh.face_slots(); ++face) {
    const double sizes = mesh.size(mesh.source(3 * face)) + mesh.size(mesh.source(3 * face + 1)) +
                         mesh.size(mesh.source(3 * face + 2));
    const FaceShape shape(mesh, face);
    has_degenerate |= shape.is_degenerate();
    faces += std::sqrt(shape.doubled_area_squared) * 9 / (sizes * sizes);
  }
  faces /= max_edge * max_edge * std::sqrt(3.0) / 2;
  if (faces > most_faces) {
    const double least = std::isfinite(faces) ? faces : most_faces;
    throw UsageError("a longest edge of " + shortest_text(max_edge) + " would make more than " +
                     shortest_text(std::floor(least / 1e6)) + " million faces: use longer edges");
  }
  return has_degenerate;
}

/// Data that all iterations of one call share.
struct Task {
  EditableMesh& mesh;
  const RemeshOptions& options;
  EdgeLimits limits;
  const ClosestPointQuery* surface;  ///< surface onto which vertices are projected, or null
  const KeepOut* keep_out;
  const Progress& progress;
  RemeshResult& result;
};

/// The steps of one iteration after the splits.
class Iteration {
 public:
  Iteration(const Task& task, EmbeddingGuard& guard)
      : task_(task), mesh_(task.mesh), roles_(mesh_, task.options.keep_border), guard_(guard) {}

  void run(bool is_first) {
    if (task_.options.only_smooth) {
      smooth(true);
      return relax();
    }
    collapse();
    flip();
    smooth(is_first);
    if (task_.options.smoothing == Smoothing::none) return;
    if (task_.options.flip == FlipRule::valence) collapse_irregular();
    flip();
    relax();
  }

  void finish() {
    const RemeshOptions& options = task_.options;
    if (options.smoothing == Smoothing::tangential && task_.surface == nullptr && !options.curved)
      smooth_bilaplacian(mesh_, guard_, roles_, task_.progress);
  }

 private:
  void collapse() {
    const CollapseCounts counts =
        collapse_short_edges(mesh_, guard_, roles_, task_.limits, task_.progress);
    task_.result.collapses += counts.done;
    task_.result.refused += counts.refused;
    task_.result.films_kept = counts.films_kept;
    remove_degenerate_faces(mesh_, guard_, roles_, task_.limits);
  }
  void collapse_irregular() {
    task_.result.collapses +=
        collapse_for_valence(mesh_, guard_, roles_, task_.limits, task_.progress);
  }
  void flip() {
    const FlipCounts counts =
        flip_edges(mesh_, guard_, task_.options.flip, task_.limits, task_.progress);
    task_.result.flips += counts.done;
    task_.result.refused += counts.refused;
  }
  void relax() {
    const SmoothCounts counts = relax_tangentially(mesh_, guard_, roles_, task_.surface,
                                                   task_.progress, task_.options.curved);
    task_.result.refused += counts.refused;
  }
  void smooth(bool is_first) {
    const RemeshOptions& options = task_.options;
    // Relaxation between collapses and flips helps only if the mesh already has good triangles.
    if (options.smoothing == Smoothing::tangential && !is_first) relax();
    const bool twice = options.smoothing == Smoothing::bilaplace;
    if (options.smoothing != Smoothing::laplace && !twice) return;
    const SmoothCounts counts = smooth_laplace(mesh_, guard_, roles_, options.smooth_first,
                                               twice ? options.smooth_second : 0, task_.progress);
    task_.result.refused += counts.refused;
  }

  const Task& task_;
  EditableMesh& mesh_;
  VertexRoles roles_;
  EmbeddingGuard& guard_;
};

/// Returns the least width of components that are kept. The width is the smaller of the shortest
/// edge and, if RemeshOptions::min_film is set, the film width.
double least_width(const Task& task) {
  const double film = task.options.min_film / sizes_of(task.mesh).largest;
  return film > 0 ? std::min(film, task.limits.shortest) : task.limits.shortest;
}

void count_removed(const RemeshResult::RemovedComponents& removed, RemeshResult& result) {
  RemeshResult::RemovedComponents& all = result.components_removed;
  all.count += removed.count;
  all.faces += removed.faces;
  all.area += removed.area;
  all.volume += removed.volume;
}

void remove_small(const Task& task) {
  if (task.options.only_smooth) return;
  const double width = least_width(task);
  count_removed(remove_small_components(task.mesh, width, task.options.keep_border), task.result);
  if (task.options.curved) count_removed(remove_thin_components(task.mesh, width), task.result);
}

/// Statistics of the lengths of all edges, relative to the local size.
struct ScaledLengths {
  double typical = 0;  ///< root mean square of the lengths
  double longest = 0;

  explicit ScaledLengths(const EditableMesh& mesh) {
    double sum = 0;
    std::size_t count = 0;
    for (Index face = 0; face < mesh.face_slots(); ++face) {
      if (!mesh.has_face(face)) continue;
      const std::array<double, 3> squared = mesh.scaled_squared_lengths(face);
      for (Index i = 0; i < 3; ++i) {
        // There is no branch here, because it is unpredictable which of two halfedges is the lower.
        const bool is_lower = 3 * face + i < mesh.opposite(3 * face + i);
        longest = std::max(longest, squared[i]);
        sum += is_lower ? squared[i] : 0;
        count += is_lower ? 1 : 0;
      }
    }
    typical = std::sqrt(sum / static_cast<double>(count));
    longest = std::sqrt(longest);
  }
};

/// If edges are far too short, collapses them in stages, each with its own guard. A single guard,
/// with cells for the final edges, would have many vertices in each cell and be slow. Returns the
/// resulting lengths.
ScaledLengths coarsen(const Task& task) {
  for (bool goes_on = true;;) {
    const ScaledLengths lengths(task.mesh);
    const double shortest = stage_growth * lengths.typical;
    if (!goes_on || !(stage_growth * shortest < task.limits.shortest)) return lengths;
    const EdgeLimits limits{shortest, shortest / task.limits.shortest * task.limits.longest,
                            task.limits.shape};
    EmbeddingGuard guard(task.mesh, limits.longest * sizes_of(task.mesh).largest, task.keep_out);
    const VertexRoles roles(task.mesh, task.options.keep_border);
    const CollapseCounts counts =
        collapse_short_edges(task.mesh, guard, roles, limits, task.progress);
    task.result.collapses += counts.done;
    task.result.kept_out += guard.kept_out();
    goes_on = counts.done > 0;
  }
}

std::unique_ptr<EmbeddingGuard> make_guard(const Task& task,
                                           std::optional<double> longest_edge = std::nullopt) {
  const double stretched = task.limits.stretched();
  const double lifted = task.options.curved ? lifted_edge * ScaledLengths(task.mesh).longest : 0;
  return std::make_unique<EmbeddingGuard>(task.mesh,
                                          std::max(stretched, lifted) * sizes_of(task.mesh).largest,
                                          task.keep_out, longest_edge);
}

/// Collapses edges that are far too short, and splits edges that are too long. Returns the guard
/// for the resulting mesh.
std::unique_ptr<EmbeddingGuard> refine(const Task& task) {
  const ScaledLengths lengths = coarsen(task);
  if (lengths.longest <= task.limits.longest) {
    if (task.mesh.has_sizes()) return make_guard(task);
    return make_guard(task, lengths.longest);
  }
  const SafeSplitOptions options{{task.limits.longest, task.options.keep_border},
                                 [&] { return make_guard(task); }};
  SafeSplits splits = task.options.curved
                          ? split_onto_curves(task.mesh, options, task.options.flip, task.limits,
                                              task.result.flips, task.progress)
                          : split_safely(task.mesh, options, task.progress);
  task.result.splits += splits.done;
  task.result.refused = splits.refused;
  return std::move(splits.guard);
}

void iterate(const Task& task, bool is_first, bool is_finish) {
  mark_features(task.mesh, task.options.feature_angle_deg);
  task.result.refused = 0;
  const std::unique_ptr<EmbeddingGuard> guard =
      task.options.only_smooth ? make_guard(task) : refine(task);
  Iteration iteration(task, *guard);
  iteration.run(is_first);
  if (is_finish) iteration.finish();
  task.result.kept_out += guard->kept_out();
  remove_small(task);
}

/// Removes slivers, and counts the slivers that are left.
void treat_slivers(const Task& task) {
  const SliverTest is_sliver(task.mesh, task.limits.shortest * sizes_of(task.mesh).smallest);
  Slivers left = count_slivers(task.mesh, is_sliver);
  if (left.kept > 0 && !task.options.only_smooth) {
    remove_slivers(task.mesh, VertexRoles(task.mesh, task.options.keep_border), is_sliver);
    left = count_slivers(task.mesh, is_sliver);
  }
  task.result.degenerate_faces = left.degenerate;
  task.result.slivers_kept = left.kept;
  task.result.first_sliver = left.place;
  task.result.faces_without_area = left.without_area;
}

RemeshResult remesh_parts(Mesh& mesh, const RemeshOptions& given, const Progress& progress,
                          std::vector<Index> opposites) {
  if (mesh.faces.empty() || mesh.positions.empty())
    throw InputError("the mesh has no faces, so there is nothing to remesh");
  check_size(mesh);
  progress("connect");
  if (opposites.empty()) opposites = manifold_opposites(mesh);
  EditableMesh editable(mesh, std::move(opposites));
  editable.set_coordinate(given.coordinate);
  const RemeshOptions options = with_feature_angle(given, editable);
  const EdgeLimits limits = set_sizes(editable, mesh, options);
  const bool has_degenerate = survey_faces(editable, limits.longest);
  std::optional<ClosestPointQuery> surface;
  // Only vertices that are smoothed are projected.
  const bool projects = options.project || options.adaptive_error > 0;
  if (projects && options.smoothing != Smoothing::none) surface.emplace(mesh);

  RemeshResult result;
  result.feature_angle_deg = options.feature_angle_deg;
  std::optional<KeepOut> keep_out;
  if (options.keep_out.surface != nullptr) {
    keep_out.emplace(options.keep_out);
    result.near_keep_out = keep_out->count_near(mesh);
  }
  const Task task{
      editable, options, limits, surface ? &*surface : nullptr, keep_out ? &*keep_out : nullptr,
      progress, result};
  remove_small(task);
  if (has_degenerate) treat_slivers(task);
  if (options.iterations > 0 && !options.only_smooth && !keep_out)
    result.collapses +=
        collapse_high_valence_stars(editable, options.keep_border, limits, progress);
  if (options.iterations > 1) editable.set_components(closed_components(editable));
  for (int i = 0; i < options.iterations; ++i)
    iterate(task, i == 0, i + 1 == options.iterations && i + 1 >= iterations_anew);
  treat_slivers(task);
  Mesh remeshed = editable.to_mesh();
  if (remeshed.faces.empty()) {
    const std::size_t count = result.components_removed.count;
    const std::string all =
        count == 1 ? "the only component is" : "all " + counted(count, "component") + " are";
    throw GoalError(ErrorKind::component_too_small,
                    all + " smaller than the shortest edge " + shortest_text(options.min_edge) +
                        ", so nothing would be left",
                    {.counts = {count}, .lengths = {options.min_edge}});
  }
  mesh = std::move(remeshed);
  result.columns = refresh_columns(mesh);
  return result;
}

}  // namespace

RemeshResult remesh_connected(Mesh& mesh, const RemeshOptions& options, const Progress& progress,
                              std::vector<Index> opposites) {
  check_options(options);
  if (options.pinch == 0) return remesh_parts(mesh, options, progress, std::move(opposites));
  Mesh parted = mesh;
  const PinchResult pinched = pinch(parted, options.pinch, options.coordinate, progress);
  if (pinched.cut > 0) opposites.clear();
  RemeshResult result = remesh_parts(parted, options, progress, std::move(opposites));
  mesh = std::move(parted);
  result.pinched = pinched.cut;
  result.pinch_refused = pinched.refused;
  return result;
}

RemeshResult remesh(Mesh& mesh, const RemeshOptions& options, const Progress& progress) {
  return remesh_connected(mesh, options, progress, {});
}

}  // namespace transformesh
