#include "transformesh/check_mesh.h"

#include <string>

#include "clean/certify/certify.h"
#include "geometry/numbers/predicates.h"
#include "support/counted.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

Problem problem_of(const std::vector<FacePair>& pairs) {
  if (pairs.empty()) return {};
  const bool is_one = pairs.size() == 1;
  return {
      ErrorKind::self_intersections,
      counted(pairs.size(), "pair") +
          (is_one ? " of faces intersects: faces " : " of faces intersect, the first are faces ") +
          std::to_string(pairs[0].first) + " and " + std::to_string(pairs[0].second),
      {.faces = {pairs[0].first, pairs[0].second}, .counts = {pairs.size()}}};
}

Problem problem_without_area(const std::vector<Index>& faces) {
  if (faces.empty()) return {};
  return {ErrorKind::other,
          counted(faces.size(), "face") +
              (faces.size() == 1 ? " has no area, face " : " have no area, the first is face ") +
              std::to_string(faces[0]),
          {.faces = {faces[0]}, .counts = {faces.size()}}};
}

void certify_mesh(const Mesh& mesh, const CheckMeshOptions& options, const Progress& progress,
                  MeshCheck& check) {
  CertifyOptions how;
  how.winding_level = options.winding_level;
  how.coordinate = options.coordinate;
  check.certificate = certify(*options.certified, mesh, how, progress);
  check.problems.push_back(
      manifold_problem(mesh, check.manifold, check.certificate->input_is_closed));
  check.problems.push_back(problem_without_area(degenerate_faces(mesh)));
  check.problems.push_back({ErrorKind::other, check.certificate->problem});
}

}  // namespace

MeshCheck check_mesh(const Mesh& mesh, const CheckMeshOptions& options, const Progress& progress) {
  if (options.winding_level < 1) throw UsageError("the winding level must be at least 1");
  progress("checking edges and vertices");
  MeshCheck check;
  check.manifold = check_manifold(mesh);
  check.degenerate_faces = degenerate_faces(mesh).size();
  const Components parts = connected_components(mesh);
  check.components = parts.components.size();
  check.genus = parts.genus();
  check.problems.push_back(manifold_problem(mesh, check.manifold, options.closed));
  if (options.intersections || options.certified != nullptr) {
    check.intersections = find_intersections(mesh, progress);
    check.problems.push_back(problem_of(*check.intersections));
  }
  if (options.certified != nullptr) certify_mesh(mesh, options, progress, check);
  std::erase_if(check.problems, [](const Problem& problem) { return problem.sentence.empty(); });
  return check;
}

}  // namespace transformesh
