#include "transformesh/decimate.h"

#include <string>

#include "clean/flat/merge_flat.h"
#include "mesh/surface_columns.h"
#include "remesh/decimator.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Decimation counts as successful if the result has at most this share more faces than wanted.
constexpr double tolerance = 0.01;

void check(const Mesh& mesh, const DecimateOptions& options) {
  if (mesh.faces.empty())
    throw InputError("the mesh has no faces, so there is nothing to decimate");
  const bool is_chosen = options.faces > 0 || !options.error;
  if (is_chosen && options.faces < least_faces)
    throw UsageError("a closed surface has at least 4 faces; " + std::to_string(options.faces) +
                     " are too few");
  if (options.error && !(*options.error >= 0)) throw UsageError("the error must not be negative");
  const bool is_bound = options.keep_border || options.keep_out.surface != nullptr;
  if (options.error == 0.0 && is_bound)
    throw UsageError(
        "an error of 0 merges flat faces, which moves vertices by rounding errors: allow an error "
        "above 0 to keep borders or a distance from another surface");
}

/// Merges coplanar faces. Nothing is merged if a border or a distance has to be kept, or if merging
/// exceeds the error.
MergeFlatResult merge_flat_faces(Mesh& mesh, const DecimateOptions& options,
                                 const Progress& progress) {
  if (options.keep_border || options.keep_out.surface != nullptr) return {};
  const EditableMesh is_manifold(mesh);  // throws if the mesh is not an oriented manifold
  Mesh merged = mesh;
  const MergeFlatResult result = merge_flat(merged, std::vector<char>(mesh.faces.size(), 1),
                                            flat_spacings, options.coordinate, progress);
  const bool is_within = options.error.value_or(0) == 0 || result.displacement < *options.error;
  if (!is_within || result.removed_faces == 0) return {};
  mesh = std::move(merged);
  return result;
}

DecimateResult without_collapses(const Mesh& mesh) {
  DecimateResult result;
  result.faces = mesh.faces.size();
  return result;
}

/// Merges flat faces first: collapsing them one by one would update the error bound many times.
DecimateResult decimate_within(Mesh& mesh, const DecimateOptions& options,
                               const Progress& progress) {
  Mesh start = mesh;
  const MergeFlatResult merged = merge_flat_faces(start, options, progress);
  DecimateResult result = without_collapses(start);
  if (*options.error > 0) {
    Decimator decimator(start, options, *options.error - merged.displacement, progress);
    result = decimator.run();
    start = decimator.to_mesh();
  }
  result.merged_faces = merged.removed_faces;
  result.error_bound += merged.displacement;
  mesh = std::move(start);
  return result;
}

bool has_too_many(const DecimateResult& result, const DecimateOptions& options) {
  return static_cast<double>(result.faces) > (1 + tolerance) * static_cast<double>(options.faces);
}

GoalError stuck(const DecimateResult& result, const DecimateOptions& options) {
  return {ErrorKind::decimation_stuck,
          std::to_string(result.faces) + " faces are left, more than the " +
              std::to_string(options.faces) +
              " wanted: further collapses would change the topology, flip faces, or make the "
              "surface touch itself or come too near to the other surface",
          {.counts = {result.faces, options.faces}}};
}

/// Collapses edges until `faces` or less are left, or until every further collapse is refused.
DecimateResult collapse_edges(Mesh& mesh, const DecimateOptions& options,
                              const Progress& progress) {
  if (mesh.faces.size() <= options.faces) return without_collapses(mesh);
  Decimator decimator(mesh, options, std::nullopt, progress);
  const DecimateResult result = decimator.run();
  mesh = decimator.to_mesh();
  return result;
}

/// Collapses edges of the mesh. If no further edge can be collapsed, starts again with merged flat
/// faces: between slivers as thin as rounding errors, every single collapse counts as contact.
DecimateResult decimate_to(Mesh& mesh, const DecimateOptions& options, const Progress& progress) {
  Mesh decimated = mesh;
  DecimateResult result = collapse_edges(decimated, options, progress);
  if (has_too_many(result, options)) {
    decimated = mesh;
    const MergeFlatResult merged = merge_flat_faces(decimated, options, progress);
    if (merged.removed_faces > 0) result = collapse_edges(decimated, options, progress);
    result.merged_faces = merged.removed_faces;
  }
  if (has_too_many(result, options)) throw stuck(result, options);
  mesh = std::move(decimated);
  return result;
}

}  // namespace

DecimateResult decimate(Mesh& mesh, const DecimateOptions& options, const Progress& progress) {
  check(mesh, options);
  if (mesh.faces.size() <= options.faces) return without_collapses(mesh);
  progress("connect");
  DecimateResult result = options.error ? decimate_within(mesh, options, progress)
                                        : decimate_to(mesh, options, progress);
  result.columns = refresh_columns(mesh);
  return result;
}

}  // namespace transformesh
