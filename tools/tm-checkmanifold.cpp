/// tm-checkmanifold: whether a mesh is an oriented manifold, and where it is not.
#include "tm/clean/intersect.h"
#include "tm/geometry/degenerate_faces.h"
#include "tm/mesh/components.h"
#include "tm/mesh/manifold.h"
#include "tool.h"

namespace {

using namespace transformesh;

struct Options {
  bool closed = false;
  bool intersections = false;
  bool pass = false;
};

void report_counts(const Mesh& mesh, const ManifoldReport& found, tool::Run& run) {
  long genus = 0;
  const Components parts = connected_components(mesh);
  for (const Component& component : parts.components) genus += component.genus();
  run.report("manifold", found.is_manifold());
  run.report("oriented", found.is_oriented());
  run.report("closed", found.is_closed());
  run.report("nonmanifold_edges", found.nonmanifold_edges.size());
  run.report("nonmanifold_vertices", found.nonmanifold_vertices.size());
  run.report("misoriented_edges", found.misoriented_edges.size());
  run.report("collapsed_faces", found.collapsed_faces.size());
  run.report("border_edges", found.border_halfedges.size());
  run.report("boundary_loops", found.boundary_loops);
  run.report("degenerate_faces", degenerate_faces(mesh).size());
  run.report("isolated_vertices", found.isolated_vertices.size());
  run.report("components", parts.components.size());
  run.report("genus", genus);
}

std::string describe_intersections(const std::vector<FacePair>& pairs) {
  if (pairs.empty()) return {};
  return std::to_string(pairs.size()) + " pairs of faces intersect, the first are faces " +
         std::to_string(pairs[0].first) + " and " + std::to_string(pairs[0].second) +
         "; remove them with tm-clean";
}

bool check(const Document& document, const Options& options, tool::Run& run) {
  run.progress()("checking edges and vertices");
  const ManifoldReport found = check_manifold(document.mesh);
  report_counts(document.mesh, found, run);
  std::string problem = describe_problem(document.mesh, found, options.closed);
  if (options.intersections) {
    const std::vector<FacePair> pairs = find_intersections(document.mesh, run.progress());
    run.report("intersections", pairs.size());
    if (problem.empty()) problem = describe_intersections(pairs);
  }
  if (!problem.empty()) run.report("problem", problem);
  if (!problem.empty() && options.pass) run.note(problem);
  return problem.empty();
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program("tm-checkmanifold", "[OPTION]... [INPUT]",
                        "Checks that a mesh is an oriented manifold, and says where it is not");
  program.flag("closed", &options.closed, "a border is a problem too");
  program.flag("intersections", &options.intersections, "faces that intersect are a problem too");
  program.flag("pass", &options.pass,
               "pass the mesh on; on a problem write nothing and exit with 1");
  return program.predicate_or_filter(
      argc, argv, &options.pass,
      [&](Document& document, tool::Run& run) { return check(document, options, run); });
}
