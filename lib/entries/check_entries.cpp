// Report entries (names and values for reports and Python) of comparisons, certificates and checks
// of meshes.
#include "entries/entries.h"
#include "transformesh/check_mesh.h"
#include "transformesh/compare.h"

namespace transformesh {

Entries entries_of(const Comparison& result) {
  return {{"accuracy", result.accuracy},
          {"completeness", result.completeness},
          {"mean", result.mean},
          {"rms", result.rms},
          {"hausdorff", result.hausdorff},
          {"hausdorff_to_reference", result.hausdorff_to_reference},
          {"hausdorff_from_reference", result.hausdorff_from_reference},
          {"volume_difference", result.volume_difference}};
}

Entries entries_of(const Certificate& result) {
  Entries entries{{"winding", result.input_is_closed ? "tested" : "not tested, the input is open"},
                  {"certified_samples", result.samples},
                  {"undecided_samples", result.undecided},
                  {"undecided_share", result.undecided_share()},
                  {"wrong_samples", result.wrong}};
  if (result.input_is_closed) entries.emplace_back("margin", result.margin);
  return entries;
}

Entries entries_of(const MeshCheck& result) {
  const ManifoldReport& found = result.manifold;
  Entries entries{{"manifold", found.is_manifold()},
                  {"oriented", found.is_oriented()},
                  {"closed", found.is_closed()},
                  {"nonmanifold_edges", found.nonmanifold_edges.size()},
                  {"nonmanifold_vertices", found.nonmanifold_vertices.size()},
                  {"misoriented_edges", found.misoriented_edges.size()},
                  {"collapsed_faces", found.collapsed_faces.size()},
                  {"border_edges", found.border_halfedges.size()},
                  {"touching_borders", found.touching_borders},
                  {"boundary_loops", found.boundary_loops},
                  {"degenerate_faces", result.degenerate_faces},
                  {"isolated_vertices", found.isolated_vertices.size()},
                  {"components", result.components},
                  {"genus", result.genus}};
  if (result.intersections) entries.emplace_back("intersections", result.intersections->size());
  if (result.certificate) append(entries, entries_of(*result.certificate));
  return entries;
}

}  // namespace transformesh
