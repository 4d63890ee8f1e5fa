#include "flow/conserved_volume.h"

#include <Eigen/Geometry>
#include <cmath>

#include "mesh/edges.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Volume of each component, and its rate of change under a motion of the vertices.
struct Volumes {
  std::vector<double> value;
  std::vector<double> rate;
};

/// Computes the volumes of components. Coordinates are relative to the first corner of each
/// component, so that no digits are lost far from the origin.
class ComponentVolumes {
 public:
  explicit ComponentVolumes(const Mesh& mesh)
      : mesh_(mesh), parts_(connected_components(mesh)), origins_(count()) {
    for (std::size_t f = mesh.faces.size(); f-- > 0;)
      origins_[parts_.of_face[f]] = mesh.positions[mesh.faces[f][0]];
  }

  std::size_t count() const { return parts_.components.size(); }

  Volumes at(const std::vector<Vec3>& positions, const std::vector<Vec3>& motion) const {
    Volumes sums{std::vector<double>(count(), 0), std::vector<double>(count(), 0)};
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      const auto [i, j, k] = mesh_.faces[f];
      const Index part = parts_.of_face[f];
      const Vec3 a = positions[i] - origins_[part], b = positions[j] - origins_[part],
                 c = positions[k] - origins_[part];
      sums.value[part] += a.dot(b.cross(c)) / 6;
      sums.rate[part] +=
          (motion[i].dot(b.cross(c)) + motion[j].dot(c.cross(a)) + motion[k].dot(a.cross(b))) / 6;
    }
    return sums;
  }

  /// Adds a multiple of its normal to the vector of each vertex. `factors` has the multiple for
  /// each component.
  void add(const std::vector<double>& factors, const std::vector<Vec3>& normals,
           std::vector<Vec3>& vectors) const {
    std::vector<char> is_done(vectors.size(), 0);
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f)
      for (const Index v : mesh_.faces[f]) {
        if (is_done[v] != 0) continue;
        is_done[v] = 1;
        vectors[v] += factors[parts_.of_face[f]] * normals[v];
      }
  }

 private:
  const Mesh& mesh_;
  Components parts_;
  std::vector<Vec3> origins_;
};

std::vector<Vec3> sum_of(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  std::vector<Vec3> sum(a.size());
  for (std::size_t v = 0; v < a.size(); ++v) sum[v] = a[v] + b[v];
  return sum;
}

}  // namespace

void require_volume(const Mesh& mesh) {
  const Edges edges(mesh);
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
    if (edges.halfedges(edge).size() == 1)
      throw InputError(ErrorKind::not_closed, "the mesh is open: it has no volume to keep");
}

void remove_volume_rates(const Mesh& mesh, std::vector<Vec3>& velocities) {
  const ComponentVolumes volumes(mesh);
  const std::vector<Vec3> normals = vertex_normals(mesh);
  std::vector<double> factors = volumes.at(mesh.positions, velocities).rate;
  const std::vector<double> areas = volumes.at(mesh.positions, normals).rate;
  for (std::size_t part = 0; part < factors.size(); ++part)
    factors[part] = areas[part] > 0 ? -factors[part] / areas[part] : 0;
  volumes.add(factors, normals, velocities);
}

/// Finds for each component the multiple of `directions` that restores its volume, by Newton's
/// method. The volume of a component is a cubic polynomial of this factor.
void restore_volumes(const Mesh& mesh, const std::vector<Vec3>& directions,
                     std::vector<Vec3>& displacements) {
  // If the volume is off by a tenth, four steps converge up to rounding. Long time spans may need
  // more.
  constexpr int most_steps = 8;
  const ComponentVolumes volumes(mesh);
  const std::vector<double> wanted = volumes.at(mesh.positions, directions).value;
  for (int step = 0; step < most_steps; ++step) {
    const Volumes now = volumes.at(sum_of(mesh.positions, displacements), directions);
    std::vector<double> factors(volumes.count(), 0);
    bool is_done = true;
    for (std::size_t part = 0; part < factors.size(); ++part) {
      if (!(now.rate[part] > 0) || now.value[part] == wanted[part]) continue;
      factors[part] = (wanted[part] - now.value[part]) / now.rate[part];
      is_done = false;
    }
    if (is_done) return;
    volumes.add(factors, directions, displacements);
  }
}

}  // namespace transformesh
