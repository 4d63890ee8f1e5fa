#include "transformesh/clean.h"

#include <utility>

#include "clean/box/clean_box.h"
#include "clean/stitch/separate.h"
#include "clean/whole/clean_whole.h"
#include "geometry/source_points.h"
#include "mesh/coordinate_spacing.h"
#include "mesh/surface_columns.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Name of a face attribute (column) that holds the index of the input face; present only during
/// cleaning.
constexpr const char* face_number = "tm:source-face";

void check_options(const CleanOptions& options) {
  if (options.only && !options.box)
    throw UsageError("only the faces of a box are to be written, but no box is given");
  if (!options.box) return;
  const char* const refused = options.method != ExteriorMethod::grow ? "the static test"
                              : options.outermost                    ? "outermost"
                              : options.merge_flat                   ? "merging flat faces"
                              : options.separate > 0                 ? "separate"
                                                                     : nullptr;
  if (refused)
    throw UsageError(std::string(refused) + " needs the whole mesh and cannot be used for a box");
}

void number_faces(Mesh& mesh, const char* name) {
  Column& column = mesh.face_columns.get(name, Scalar::int32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) column.values[f] = static_cast<double>(f);
}

void separate_copies(const CleanOptions& options, CleanResult& result, const Progress& progress) {
  if (options.separate == 0) return;
  const SeparateResult separated =
      separate(result.mesh, {options.separate, options.coordinate}, progress);
  result.separated_vertices = separated.separated_vertices;
  result.separation_refused = separated.refused_vertices;
  if (separated.separated_vertices == 0) return;
  if (options.refuse)
    throw GoalError(ErrorKind::needs_cleaning,
                    "several vertices have the same position and would have to be moved apart",
                    {.counts = {separated.separated_vertices}});
  result.changed = true;
}

CleanResult clean_faces(const Mesh& mesh, const CleanOptions& options, const Progress& progress) {
  CleanResult result =
      options.box ? clean_box(mesh, options, progress) : clean_whole(mesh, options, progress);
  separate_copies(options, result, progress);
  return result;
}

CleanResult clean_with_face_column(const Mesh& mesh, const CleanOptions& options,
                                   const Progress& progress) {
  Mesh numbered = mesh;
  const bool drops = drop_source_points(numbered);
  number_faces(numbered, source_point_names[0]);
  CleanResult result = clean_faces(numbered, options, progress);
  result.dropped_source_points |= drops;
  return result;
}

CleanResult clean_with_source_points(const Mesh& mesh, const CleanOptions& options,
                                     const Progress& progress) {
  Mesh numbered = mesh;
  number_faces(numbered, face_number);
  CleanResult result = clean_faces(numbered, options, progress);
  const Column& numbers = *result.mesh.face_columns.find(face_number);
  write_source_points(result.mesh, source_points_of_pieces(mesh, result.mesh, numbers.values));
  result.mesh.face_columns.erase(face_number);
  result.dropped_source_points = false;
  return result;
}

CleanResult clean_stored(const Mesh& mesh, const CleanOptions& options, const Progress& progress) {
  switch (options.sources) {
    case CleanSources::faces:
      return clean_with_face_column(mesh, options, progress);
    case CleanSources::points:
      return clean_with_source_points(mesh, options, progress);
    case CleanSources::none:
      break;
  }
  return clean_faces(mesh, options, progress);
}

}  // namespace

CleanResult clean(const Mesh& mesh, const CleanOptions& options, const Progress& progress) {
  check_options(options);
  const std::optional<Mesh> rounded = rounded_mesh(mesh, options.coordinate);
  return clean_stored(rounded ? *rounded : mesh, options, progress);
}

}  // namespace transformesh
