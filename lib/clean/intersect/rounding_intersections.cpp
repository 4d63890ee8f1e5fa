#include "clean/intersect/rounding_intersections.h"

#include <algorithm>

#include "mesh/coordinate_spacing.h"
#include "transformesh/components.h"
#include "transformesh/intersect.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Rounding is not checked if the mean edge length is at least this multiple of the coordinate
/// spacing. A choice: with a higher value, more meshes are checked, and each check is a search for
/// intersections.
constexpr double spacings_per_edge = 1000;

}  // namespace

std::size_t count_rounding_intersections(const Mesh& rounded, const std::vector<Vec3>& before) {
  if (rounded.positions == before) return 0;
  const std::vector<FacePair> pairs = find_intersections(rounded);
  if (pairs.empty()) return 0;
  std::vector<bool> meets(rounded.faces.size(), false);
  for (const auto& [f, g] : pairs) meets[f] = meets[g] = true;
  Mesh exact{before, rounded.faces, {}, {}};
  exact = select_faces(exact, meets);
  std::vector<Index> face_of;  // index in `rounded` of each face of `exact`
  for (Index f = 0; f < rounded.faces.size(); ++f)
    if (meets[f]) face_of.push_back(f);
  std::vector<FacePair> known;
  for (const auto& [f, g] : find_intersections(exact)) known.emplace_back(face_of[f], face_of[g]);
  std::vector<FacePair> only;
  std::set_difference(pairs.begin(), pairs.end(), known.begin(), known.end(),
                      std::back_inserter(only));
  return only.size();
}

std::size_t count_rounding_intersections(const Mesh& mesh, Scalar type) {
  if (mesh.faces.empty()) return 0;
  const double spacing = coordinate_spacing(mesh, type);
  if (!(edge_lengths(mesh).mean < spacings_per_edge * spacing)) return 0;
  Mesh rounded = mesh;
  for (Vec3& position : rounded.positions) position = rounded_to(position, type);
  return count_rounding_intersections(rounded, mesh.positions);
}

}  // namespace transformesh
