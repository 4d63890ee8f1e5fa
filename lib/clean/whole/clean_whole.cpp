#include "clean/whole/clean_whole.h"

#include <algorithm>
#include <string>
#include <utility>

#include "clean/exterior/exterior.h"
#include "clean/flat/changed_faces.h"
#include "clean/flat/merge_flat.h"
#include "clean/pass/clean_pass.h"
#include "clean/rounding/snap_rounding.h"
#include "clean/stitch/double_sided.h"
#include "mesh/surface_columns.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// If at least this fraction of faces coincides with a face of opposite orientation, the error
/// message gives this as the reason why the mesh encloses nothing. A choice.
constexpr double double_sided_share = 0.5;

/// Returns the error for a mesh of which `reverses` faces coincide with a face of opposite
/// orientation. A solid minus itself and a double-sided solid are the same mesh, so the message
/// names both causes. If the mesh is open after one face of each pair is removed, the message
/// names sheets whose borders are filled flat, and double-sided sheets.
Problem problem_of_reverses(const Mesh& mesh, std::size_t reverses) {
  const bool is_sheet = one_side_is_open(mesh);
  return {is_sheet ? ErrorKind::double_sided_sheet : ErrorKind::double_sided,
          "the faces enclose nothing: " + std::to_string(reverses) + " of " +
              std::to_string(mesh.faces.size()) +
              " coincide with a face of opposite orientation, as in " +
              (is_sheet ? "sheets whose borders are filled flat, and in double-sided sheets"
                        : "an empty difference, and in double-sided models"),
          {.counts = {reverses, mesh.faces.size()}}};
}

[[noreturn]] void refuse_changes(const CleanResult& result) {
  const bool only_joins =
      result.pairs == 0 && result.removed_faces == 0 && result.copied_vertices == 0;
  throw GoalError(ErrorKind::needs_cleaning,
                  "the mesh needs cleaning (" + std::to_string(result.pairs) +
                      " intersecting face pairs, " + std::to_string(result.removed_faces) +
                      " faces to remove, " + std::to_string(result.copied_vertices) +
                      " vertices to duplicate" + (only_joins ? ", but vertices to merge)" : ")"),
                  {.counts = {result.pairs, result.removed_faces, result.copied_vertices}});
}

CleanResult counts_of(const CleanPass& pass) {
  CleanResult result;
  result.pairs = pass.pairs;
  result.pieces = pass.pieces;
  result.cut_faces = pass.cut_faces;
  result.removed_faces = pass.removed_faces;
  result.patches = pass.open_patches;
  result.decided_by_number = pass.decided_by_number;
  result.least_margin = pass.least_margin;
  result.rays = pass.rays;
  result.changed = !pass.unchanged;
  return result;
}

void take_rounded(SnapRoundingResult rounded, CleanResult& result) {
  result.cut_faces += rounded.cut_faces;
  result.removed_faces += rounded.removed_faces;
  result.new_vertices = rounded.new_vertices;
  result.copied_vertices = rounded.copied_vertices;
  result.rounding_repairs = rounded.repairs;
  result.rounding_places = rounded.places;
  result.rounding_faces = rounded.faces;
  result.rounding_pairs = rounded.pairs;
  result.rounding_level = rounded.level;
  result.rounding_displacement = rounded.displacement.length;
  result.rounding_spacings = rounded.displacement.spacings;
  result.mesh = std::move(rounded.mesh);
  if (result.cut_faces == 0) return;
  result.dropped_columns = drop_corner_lists(result.mesh.face_columns);
  result.dropped_source_points = drop_source_points(result.mesh);
}

void merge_changed(std::vector<char> changed, Scalar coordinate, CleanResult& result,
                   const Progress& progress) {
  const MergeFlatResult merged =
      merge_flat(result.mesh, std::move(changed), flat_spacings, coordinate, progress);
  result.merged_faces = merged.removed_faces;
  result.merge_refused = merged.kept_regions;
  result.merge_displacement = merged.displacement;
}

void drop_enclosed(CleanResult& result) {
  const auto& known = result.connectivity;
  result.dropped_components =
      known ? drop_enclosed_components(result.mesh, connected_components(result.mesh, *known))
            : drop_enclosed_components(result.mesh);
  if (result.dropped_components == 0) return;
  result.changed = true;
  result.connectivity.reset();
}

CleanResult clean_faces_of(const Mesh& mesh, const CleanOptions& options,
                           const PieceChooser* chooser, const Progress& progress) {
  if (mesh.faces.empty()) throw InputError("the mesh has no faces: there is nothing to clean");
  CleanPassOptions pass_options{options.winding_level, options.method, true, chooser};
  pass_options.coordinate = options.coordinate;
  CleanPass pass = run_clean_pass(mesh, pass_options, progress);
  CleanResult result = counts_of(pass);
  if (pass.unchanged) {
    result.mesh = mesh;
  } else {
    const SnapRoundingOptions how{options.winding_level, options.method, pass.is_open,
                                  options.coordinate, chooser};
    SnapRoundingResult rounded = snap_round(mesh, pass, how, progress);
    std::vector<char> changed;
    if (options.merge_flat)
      changed = find_changed_faces(mesh, rounded.mesh, rounded.source_face, rounded.face_is_new);
    take_rounded(std::move(rounded), result);
    if (options.merge_flat) merge_changed(std::move(changed), options.coordinate, result, progress);
  }
  result.connectivity = std::move(pass.connectivity);
  if (options.outermost) drop_enclosed(result);
  if (options.refuse && result.changed) refuse_changes(result);
  return result;
}

}  // namespace

CleanResult clean_whole(const Mesh& mesh, const CleanOptions& options, const Progress& progress) {
  try {
    return clean_faces_of(mesh, options, nullptr, progress);
  } catch (const GoalError&) {
    const auto faces = static_cast<double>(mesh.faces.size());
    const std::size_t both = options.refuse ? 0 : count_double_sided(mesh);
    if (static_cast<double>(both) < std::max(1.0, double_sided_share * faces)) throw;
    throw GoalError(problem_of_reverses(mesh, both));
  }
}

CleanResult clean_region(const Mesh& mesh, const CleanOptions& options, const PieceChooser& chooser,
                         const Progress& progress) {
  return clean_faces_of(mesh, options, &chooser, progress);
}

}  // namespace transformesh
