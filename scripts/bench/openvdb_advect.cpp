// openvdb-advect FIELD TIME RESOLUTION SOURCE OUTPUT
//
// Moves a level set by OpenVDB, for comparison with tm-evolve. FIELD is one of these:
//
// - rotation: one turn in a unit of time about the vertical axis through (.5, .5, .5).
// - vortex: the single vortex of the unit cube, reversed at TIME / 2, so that the surface returns
// to its initial shape at TIME.
// - deformation: Enright's field, reversed in the same way.
// - normal: growth at unit speed along the normals.
// - mean-curvature: motion by the sum of the principal curvatures.
//
// The unit cube has RESOLUTION voxels along each side. Prints the CPU seconds of the motion and of
// meshing the result on one thread. They exclude reading SOURCE and its conversion to a level set.
//
// Reference: Museth, "VDB: High-resolution sparse volumes with dynamic topology", ACM Transactions
// on Graphics 32, 2013.
//
// Reference: Enright, Fedkiw, Ferziger & Mitchell, "A hybrid particle level set method for improved
// interface capturing", Journal of Computational Physics 183, 2002.
#include <openvdb/tools/LevelSetAdvect.h>
#include <openvdb/tools/LevelSetFilter.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "driver.h"
#include "mesh_file.h"
#include "openvdb_surface.h"

using namespace transformesh;
using openvdb::FloatGrid;

namespace {

constexpr double pi = std::numbers::pi;

using Velocity = openvdb::Vec3d (*)(const openvdb::Vec3d& point);

openvdb::Vec3d rotation(const openvdb::Vec3d& p) {
  return 2 * pi * openvdb::Vec3d(0.5 - p.y(), p.x() - 0.5, 0);
}

openvdb::Vec3d vortex(const openvdb::Vec3d& p) {
  const double x = std::sin(pi * p.x()), y = std::sin(pi * p.y());
  return {-x * x * std::sin(2 * pi * p.y()), std::sin(2 * pi * p.x()) * y * y, 0};
}

openvdb::Vec3d deformation(const openvdb::Vec3d& p) {
  const openvdb::Vec3d s(std::sin(pi * p.x()), std::sin(pi * p.y()), std::sin(pi * p.z()));
  const openvdb::Vec3d d(std::sin(2 * pi * p.x()), std::sin(2 * pi * p.y()),
                         std::sin(2 * pi * p.z()));
  return {2 * s.x() * s.x() * d.y() * d.z(), -d.x() * s.y() * s.y() * d.z(),
          -d.x() * d.y() * s.z() * s.z()};
}

/// A steady velocity field with the interface that LevelSetAdvection requires.
struct Field {
  using ValueType = float;
  using VectorType = openvdb::Vec3f;

  Velocity velocity;

  static openvdb::math::Transform transform() { return {}; }
  VectorType operator()(const openvdb::Vec3d& point, float) const {
    return VectorType(velocity(point));
  }
  VectorType operator()(const openvdb::Coord& ijk, float time) const {
    return (*this)(ijk.asVec3d(), time);
  }
};

using Advection = openvdb::tools::LevelSetAdvection<FloatGrid, Field>;

/// Returns an advection by the schemes of the highest order.
std::unique_ptr<Advection> advection(FloatGrid& grid, Velocity velocity) {
  auto result = std::make_unique<Advection>(grid, Field{velocity});
  result->setSpatialScheme(openvdb::math::HJWENO5_BIAS);
  result->setTemporalScheme(openvdb::math::TVD_RK3);
  result->setTrackerSpatialScheme(openvdb::math::HJWENO5_BIAS);
  result->setTrackerTemporalScheme(openvdb::math::TVD_RK3);
  // Each renormalization of the distances moves the surface. One per step is the smallest possible
  // number.
  result->setNormCount(1);
  return result;
}

/// Advects from the time 0 to `time` by the velocity field times cos(pi t / time). This equals
/// advection by the steady field for a span of time / pi, and then back for the same span. The span
/// is the integral of the cosine up to its zero. The substitution is exact, and allows the longest
/// stable steps.
void advect_there_and_back(FloatGrid& grid, Velocity velocity, double time) {
  const auto there_and_back = advection(grid, velocity);
  const auto span = static_cast<float>(time / pi);
  there_and_back->advect(0, span);
  there_and_back->advect(span, 0);
}

/// Moves the surface by the sum of the principal curvatures. A step of LevelSetFilter moves it by
/// their mean, for a time of a third of the squared voxel size. For motion by the sum, the same
/// step takes half of this time. The number of steps is rounded.
void flow_by_curvature(openvdb::tools::LevelSetFilter<FloatGrid>& filter, double voxel,
                       double time) {
  const auto steps = std::lround(6 * time / (voxel * voxel));
  for (long step = 0; step < steps; ++step) filter.meanCurvature();
}

void move(FloatGrid& grid, const std::string& field, double time, double voxel) {
  openvdb::tools::LevelSetFilter<FloatGrid> filter(grid);
  if (field == "rotation") {
    advection(grid, rotation)->advect(0, static_cast<float>(time));
  } else if (field == "vortex") {
    advect_there_and_back(grid, vortex, time);
  } else if (field == "deformation") {
    advect_there_and_back(grid, deformation, time);
  } else if (field == "normal") {
    filter.offset(static_cast<float>(-time));
  } else if (field == "mean-curvature") {
    flow_by_curvature(filter, voxel, time);
  } else {
    throw InputError("unknown field " + field);
  }
}

void measure(const std::string& field, double time, double voxel, const std::string& source,
             const std::string& output) {
  const Mesh mesh = read_file(source);
  const OneThread one_thread;
  const FloatGrid::Ptr grid = level_set(mesh, voxel);
  time_surface(output, [&] {
    move(*grid, field, time, voxel);
    return grid;
  });
}

}  // namespace

int main(int argc, char** argv) {
  return drive({argv, static_cast<std::size_t>(argc)},
               "openvdb-advect FIELD TIME RESOLUTION SOURCE OUTPUT", [](const auto& words) {
                 measure(words[0], std::stod(words[1]), 1 / std::stod(words[2]), words[3],
                         words[4]);
               });
}
