#include "remesh/pinch.h"

#include "fill/necks.h"
#include "transformesh/clean.h"
#include "transformesh/handles.h"
#include "transformesh/intersect.h"

namespace transformesh {

PinchResult pinch(Mesh& mesh, double length, Scalar coordinate, const Progress& progress) {
  const HandleResult handles = remove_handles(mesh, {length, coordinate}, progress);
  const NeckResult necks = cut_necks(mesh, length, coordinate, progress);
  const PinchResult result{handles.removed + necks.cut,
                           handles.refused + handles.blocked + necks.refused};
  if (result.cut == 0 || find_intersections(mesh, progress).empty()) return result;
  CleanOptions options;
  options.coordinate = coordinate;
  mesh = clean(mesh, options, progress).mesh;
  return result;
}

}  // namespace transformesh
