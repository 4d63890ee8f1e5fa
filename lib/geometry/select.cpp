#include "transformesh/select.h"

#include <algorithm>

#include "geometry/component_around.h"
#include "mesh/face_conditions.h"
#include "support/counted.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

void meet(std::vector<bool>& keep, const std::vector<bool>& more) {
  for (std::size_t f = 0; f < keep.size(); ++f) keep[f] = keep[f] && more[f];
}

void check_mask(const std::vector<bool>& mask, const Mesh& mesh) {
  if (mask.size() != mesh.faces.size())
    throw InputError("the mask has " + counted(mask.size(), "value") + ", but " +
                     there_are(mesh.faces.size(), "face"));
}

}  // namespace

SelectionResult select(Mesh& mesh, const SelectionOptions& options) {
  if (options.mask) check_mask(*options.mask, mesh);
  SelectionResult result;
  std::vector<bool> keep(mesh.faces.size(), true);
  if (options.largest) meet(keep, faces_of_largest(mesh, *options.largest, options.by));
  if (options.at_least > 0) meet(keep, faces_of_at_least(mesh, options.at_least, options.by));
  if (!options.where.empty()) meet(keep, faces_where(mesh, options.where));
  if (options.box) meet(keep, faces_in_box(mesh, *options.box));
  if (options.around) {
    const ComponentAround found = component_around(mesh, *options.around);
    meet(keep, found.faces);
    result.contains_point = found.contains_point;
    result.distance = found.distance;
  }
  if (options.mask) meet(keep, *options.mask);
  if (options.invert) keep.flip();

  result.selected_faces = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), true));
  result.dropped_faces = keep.size() - result.selected_faces;
  if (result.selected_faces == 0)
    throw GoalError("none of " + counted(keep.size(), "face") +
                    " is selected: loosen the conditions, or invert them");
  mesh = select_faces(mesh, keep);
  return result;
}

}  // namespace transformesh
