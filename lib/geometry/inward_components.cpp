#include "geometry/inward_components.h"

#include <cmath>
#include <span>

#include "geometry/numbers/exact_number.h"
#include "geometry/numbers/machine_epsilon.h"
#include "geometry/numbers/number_vector.h"

namespace transformesh {
namespace {

/// Returns the sum of six times the volumes of the tetrahedra between `origin` and the faces.
template <class Number>
Number six_volumes(const Mesh& mesh, std::span<const Index> faces, const Vec3& origin) {
  const auto way_to = [&](Index v) { return difference<Number>(mesh.positions[v], origin); };
  Number sum(0.0);
  for (const Index f : faces) {
    const auto& [a, b, c] = mesh.faces[f];
    sum = sum + dot(way_to(a), cross(way_to(b), way_to(c)));
  }
  return sum;
}

/// Returns the sum of the absolute values of all products in six_volumes().
double sum_of_products(const Mesh& mesh, std::span<const Index> faces, const Vec3& origin) {
  double sum = 0;
  for (const Index f : faces) {
    const auto& [a, b, c] = mesh.faces[f];
    const Vec3 p = (mesh.positions[a] - origin).cwiseAbs();
    const Vec3 q = (mesh.positions[b] - origin).cwiseAbs();
    const Vec3 r = (mesh.positions[c] - origin).cwiseAbs();
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      sum += p[i] * (q[j] * r[k] + q[k] * r[j]);
    }
  }
  return sum;
}

/// Returns the sign of the volume inside a closed surface.
int volume_sign(const Mesh& mesh, std::span<const Index> faces) {
  const Vec3& origin = mesh.positions[mesh.faces[faces.front()][0]];
  const double volumes = six_volumes<double>(mesh, faces, origin);
  const double products = sum_of_products(mesh, faces, origin);
  // A product of three differences has at most 5 rounding errors, a determinant 3 more, and the sum
  // one for each face.
  const double error = (static_cast<double>(faces.size()) + 16) * machine_epsilon * products;
  if (error > underflow_guard && std::abs(volumes) > error) return volumes > 0 ? 1 : -1;
  return sign_of(six_volumes<ExactNumber>(mesh, faces, origin));
}

}  // namespace

std::vector<char> inward_components(const Mesh& mesh, const Components& parts) {
  std::vector<std::vector<Index>> faces(parts.components.size());
  for (Index f = 0; f < mesh.faces.size(); ++f)
    if (parts.components[parts.of_face[f]].boundary_loops == 0)
      faces[parts.of_face[f]].push_back(f);
  std::vector<char> is_inward;
  for (const std::vector<Index>& part : faces)
    is_inward.push_back(!part.empty() && volume_sign(mesh, part) < 0 ? 1 : 0);
  return is_inward;
}

}  // namespace transformesh
