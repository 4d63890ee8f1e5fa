#include "step/morph_check.h"

#include "clean/stitch/orientation_check.h"
#include "clean/stitch/weld.h"
#include "mesh/location_text.h"
#include "support/counted.h"
#include "support/error_prefix.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

std::string named(const std::string& what, const std::string& name) {
  return name.empty() ? what : what + ' ' + name;
}

// Returns the mesh without columns, with equal positions merged. Faces that collapse are removed.
Mesh welded(const Mesh& mesh) {
  Mesh result;
  result.positions = mesh.positions;
  const std::vector<Index> first = weld_positions(mesh.positions, 0);
  for (const Face& face : mesh.faces) {
    const Face joined{first[face[0]], first[face[1]], first[face[2]]};
    if (!is_collapsed(joined)) result.faces.push_back(joined);
  }
  return result;
}

// Throws InputError if the mesh is not oriented or inside out. Returns the number of border edges.
std::size_t check_orientation(const Mesh& mesh, const std::string& what) {
  const Problem problem = find_misorientation(mesh);
  if (!problem.sentence.empty()) throw InputError(prefixed(what + " is not oriented: ", problem));
  const std::size_t borders = check_manifold(mesh).border_halfedges.size();
  if (borders == 0 && volume(mesh) < 0)
    throw InputError(ErrorKind::inside_out, what + " is inside out");
  return borders;
}

std::string box_text(const Box& box) {
  return "from " + point_text(box.min()) + " to " + point_text(box.max());
}

}  // namespace

std::vector<Problem> check_target(const Target& target, const std::string& name,
                                  const Progress& progress) {
  if (!target.is_mesh()) return {};
  std::vector<Problem> warnings;
  const std::size_t borders = check_orientation(welded(target.mesh), named("the target", name));
  if (borders > 0) {
    warnings.push_back({ErrorKind::target_open,
                        named("the target", name) + " is open, with " +
                            counted(borders, "border edge") +
                            ": a closed surface cannot lie on it, and ends on both of its sides or "
                            "passes through it",
                        {.counts = {borders}, .name = name}});
  }
  const std::size_t pairs = find_intersections(target.mesh, progress).size();
  if (pairs > 0) {
    warnings.push_back({ErrorKind::self_intersections,
                        named("the target", name) + " intersects itself at " +
                            counted(pairs, "pair") +
                            " of faces: faces inside the target cannot be reached",
                        {.counts = {pairs}, .name = name}});
  }
  return warnings;
}

std::vector<Problem> check_source(const Mesh& source, const Target& target,
                                  const std::string& name) {
  check_orientation(welded(source), named("the source", name));
  if (source.positions.empty()) return {};
  const Box ours = bounding_box(source);
  const Box theirs = bounding_box(target.mesh);
  const bool overlaps = (ours.min().array() <= theirs.max().array()).all() &&
                        (theirs.min().array() <= ours.max().array()).all();
  if (overlaps) return {};
  return {{ErrorKind::source_apart,
           "the source lies " + box_text(ours) + ", apart from the target, " + box_text(theirs) +
               ": it will shrink to nothing",
           {.name = name}}};
}

}  // namespace transformesh
