#include "geometry/numbers/volume_sign.h"

#include "geometry/numbers/bounded_number.h"
#include "geometry/numbers/exact_number.h"
#include "geometry/numbers/number_vector.h"

namespace transformesh {
namespace {

/// Returns the sum of six times the volumes of the tetrahedra between the faces and a corner.
template <class Number>
Number six_volumes(const Mesh& mesh, std::span<const Index> faces) {
  const Vec3& origin = mesh.positions[mesh.faces[faces.front()][0]];
  const auto way_to = [&](Index v) -> NumberVector<Number> {
    const Vec3& p = mesh.positions[v];
    return {Number{p[0]} - Number{origin[0]}, Number{p[1]} - Number{origin[1]},
            Number{p[2]} - Number{origin[2]}};
  };
  Number sum{0.0};
  for (const Index f : faces) {
    const auto& [a, b, c] = mesh.faces[f];
    sum = sum + dot(way_to(a), cross(way_to(b), way_to(c)));
  }
  return sum;
}

}  // namespace

int volume_sign(const Mesh& mesh, std::span<const Index> faces) {
  const int sign = six_volumes<BoundedNumber>(mesh, faces).sign();
  return sign != 0 ? sign : sign_of(six_volumes<ExactNumber>(mesh, faces));
}

}  // namespace transformesh
