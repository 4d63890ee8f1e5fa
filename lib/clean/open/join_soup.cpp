#include "clean/open/join_soup.h"

#include "clean/open/borders.h"
#include "mesh/touching_borders.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

[[noreturn]] void refuse_orientation(Mesh mesh, const std::string& problem) {
  const StitchResult oriented = stitch(mesh, {.orient = true});
  if (oriented.misoriented_edges == 0)
    throw InputError(ErrorKind::not_oriented, problem + ": the mesh is not oriented");
  throw InputError(ErrorKind::not_orientable,
                   oriented.misorientation + ", and reversing connected parts cannot change that");
}

}  // namespace

bool is_soup(const Mesh& mesh) {
  return count_touching_borders(mesh) > 0 && !is_oriented_by_indices(weld(mesh), mesh);
}

StitchResult join_soup(Mesh& mesh) {
  if (!is_soup(mesh)) return {};
  Mesh joined = mesh;
  StitchResult result = stitch(joined);
  if (result.misoriented_edges > 0) refuse_orientation(std::move(joined), result.misorientation);
  mesh = std::move(joined);
  return result;
}

}  // namespace transformesh
