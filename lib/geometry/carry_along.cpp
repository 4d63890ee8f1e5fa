#include <string>

#include "geometry/source_points.h"
#include "transformesh/carry.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Returns the name of a mesh, or its number counted from 1.
std::string name_in(const CarryOptions& options, std::size_t number) {
  return number < options.names.size() ? options.names[number]
                                       : "mesh " + std::to_string(number + 1);
}

/// Returns the source points of mesh `number` of the chain: for each vertex and face of `mesh`, the
/// place on the previous mesh `before` from which it came.
SourcePoints places_on(const Mesh& before, const Mesh& mesh, std::size_t number,
                       const CarryOptions& options) {
  if (has_source_points(mesh))
    return read_source_points(mesh, before.faces.size(), name_in(options, number - 1));
  if (options.closest) return closest_source_points(before, mesh);
  throw InputError(ErrorKind::no_source_points,
                   name_in(options, number) + " has no source points of its vertices and faces",
                   {.name = name_in(options, number)});
}

}  // namespace

CarryResult carry_along(std::span<const Mesh* const> before, Mesh& last,
                        const CarryOptions& options) {
  if (before.empty())
    throw UsageError("at least two meshes are needed: one to carry from and one to carry to");
  const Mesh& first = *before[0];
  const auto mesh_at = [&](std::size_t i) -> const Mesh& {
    return i < before.size() ? *before[i] : last;
  };
  SourcePoints on_first = places_on(first, mesh_at(1), 1, options);
  for (std::size_t i = 2; i <= before.size(); ++i)
    on_first = compose_source_points(first, on_first, mesh_at(i - 1),
                                     places_on(mesh_at(i - 1), mesh_at(i), i, options));
  const CarryResult result = carry_columns(first, on_first, last, options.columns);
  write_source_points(last, on_first);
  return result;
}

}  // namespace transformesh
