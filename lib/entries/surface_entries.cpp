// Report entries (names and values for reports and Python) of operations that change a mesh without
// iterations of an evolution, such as cleaning, repair and remeshing.
#include <array>

#include "entries/entries.h"
#include "transformesh/align.h"
#include "transformesh/align_features.h"
#include "transformesh/carry.h"
#include "transformesh/clean_result.h"
#include "transformesh/decimate.h"
#include "transformesh/fill.h"
#include "transformesh/handles.h"
#include "transformesh/remesh.h"
#include "transformesh/repair.h"
#include "transformesh/select.h"
#include "transformesh/stitch.h"
#include "transformesh/transform.h"

namespace transformesh {
namespace {

std::vector<double> numbers_of(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

void append_step(Entries& entries, const std::string& name, const RepairStep& step) {
  constexpr std::array operations{"stitch", "fill", "clean", "select"};
  std::string found;
  for (const std::string& finding : step.findings) found += (found.empty() ? "" : ", ") + finding;
  append(entries, {{name, operations[step.operation.index()]},
                   {name + "_found", found},
                   {name + "_count", step.count},
                   {name + "_place", numbers_of(step.place)},
                   {name + "_area_change", step.area_change},
                   {name + "_volume_change", step.volume_change},
                   {name + "_lost_share", step.lost_share},
                   {name + "_lost_place", numbers_of(step.lost_place)}});
}

}  // namespace

Entries entries_of(const CleanResult& result) {
  return {{"changed", result.changed},
          {"pairs", result.pairs},
          {"pieces", result.pieces},
          {"cut_faces", result.cut_faces},
          {"removed_faces", result.removed_faces},
          {"new_vertices", result.new_vertices},
          {"copied_vertices", result.copied_vertices},
          {"patches", result.patches},
          {"decided_by_number", result.decided_by_number},
          {"least_margin", result.least_margin},
          {"rays", result.rays},
          {"dropped_components", result.dropped_components},
          {"rounding_repairs", result.rounding_repairs},
          {"rounding_places", result.rounding_places},
          {"rounding_faces", result.rounding_faces},
          {"rounding_pairs", result.rounding_pairs},
          {"rounding_level", result.rounding_level},
          {"rounding_displacement", result.rounding_displacement},
          {"rounding_spacings", result.rounding_spacings},
          {"merged_faces", result.merged_faces},
          {"merge_refused", result.merge_refused},
          {"merge_displacement", result.merge_displacement},
          {"separated_vertices", result.separated_vertices},
          {"separation_refused", result.separation_refused}};
}

Entries entries_of(const StitchResult& result) {
  return {
      {"joined_vertices", result.joined_vertices},     {"copied_vertices", result.copied_vertices},
      {"split_borders", result.split_borders},         {"split_edges", result.split_edges},
      {"dropped_faces", result.dropped_faces},         {"dropped_copies", result.dropped_copies},
      {"dropped_reverses", result.dropped_reverses},   {"turned_faces", result.reversed_faces},
      {"misoriented_edges", result.misoriented_edges}, {"border_edges", result.border_edges}};
}

Entries entries_of(const FillResult& result) {
  return {{"holes", result.holes},
          {"filled", result.filled()},
          {"faired", result.faired},
          {"refined", result.refined},
          {"plain", result.plain},
          {"crossed", result.crossed},
          {"left_crossing", result.crossing.size()},
          {"left_flat", result.flat.size()},
          {"left_too_large", result.too_large.size()},
          {"cut_edges", result.cut_edges},
          {"new_vertices", result.new_vertices},
          {"new_faces", result.new_faces}};
}

Entries entries_of(const HandleResult& result) {
  return {{"removed", result.removed},
          {"refused", result.refused},
          {"blocked", result.blocked},
          {"new_vertices", result.new_vertices},
          {"new_faces", result.new_faces}};
}

Entries entries_of(const RepairResult& result) {
  Entries entries{{"steps", result.steps.size()},          {"crack_width", result.crack_width},
                  {"area_before", result.area_before},     {"area_after", result.area_after},
                  {"volume_before", result.volume_before}, {"volume_after", result.volume_after}};
  for (std::size_t i = 0; i < result.steps.size(); ++i)
    append_step(entries, "step_" + std::to_string(i + 1), result.steps[i]);
  return entries;
}

Entries entries_of(const RemeshResult& result) {
  Entries entries{{"splits", result.splits},
                  {"collapses", result.collapses},
                  {"flips", result.flips},
                  {"refused", result.refused},
                  {"kept_out", result.kept_out},
                  {"films_kept", result.films_kept},
                  {"pinched", result.pinched},
                  {"pinch_refused", result.pinch_refused},
                  {"components_dropped", result.components_removed.count},
                  {"components_dropped_faces", result.components_removed.faces},
                  {"components_dropped_area", result.components_removed.area},
                  {"components_dropped_volume", result.components_removed.volume},
                  {"degenerate_faces", result.degenerate_faces},
                  {"slivers_kept", result.slivers_kept},
                  {"faces_without_area", result.faces_without_area}};
  const Vec3& sliver = result.first_sliver;
  if (result.slivers_kept > 0)
    entries.emplace_back("first_sliver", std::vector<double>{sliver.x(), sliver.y(), sliver.z()});
  entries.emplace_back("feature_angle", result.feature_angle_deg);
  return entries;
}

Entries entries_of(const DecimateResult& result) {
  return {{"collapses", result.collapses},         {"faces", result.faces},
          {"kept_out", result.kept_out},           {"merged_faces", result.merged_faces},
          {"error_refused", result.error_refused}, {"error_bound", result.error_bound}};
}

Entries entries_of(const AlignResult& result) {
  return {{"sharp_edges", result.sharp_edges},
          {"corners", result.corners},
          {"aligned", result.aligned}};
}

Entries entries_of(const TransformResult& result) {
  return {{"scale", result.scale}, {"mirrored", result.is_mirror}};
}

Entries entries_of(const RegistrationResult& result) {
  const Matrix4 rows = result.motion.transpose();
  return {{"rms", result.rms},
          {"overlap", result.overlap},
          {"rotation", result.rotation_deg},
          {"stability", result.stability},
          {"iterations", static_cast<std::size_t>(result.iterations)},
          {"converged", result.has_converged},
          {"matrix", std::vector<double>(rows.data(), rows.data() + rows.size())}};
}

Entries entries_of(const SelectionResult& result) {
  Entries entries{{"selected_faces", result.selected_faces},
                  {"dropped_faces", result.dropped_faces}};
  if (!result.contains_point) return entries;
  entries.emplace_back("contains_point", *result.contains_point);
  entries.emplace_back("distance", result.distance);
  return entries;
}

Entries entries_of(const CarryResult& result) {
  return {{"vertex_columns", result.vertex_columns}, {"face_columns", result.face_columns}};
}

}  // namespace transformesh
