// Morphs level sets by OpenVDB, for comparison with tm-morph. Converts both meshes to narrow bands
// of three voxels, applies LevelSetMorphing until the volume is constant, and meshes the result.
// Prints the CPU seconds of this on one thread, without reading and writing files.
//   openvdb-morph VOXEL SOURCE TARGET OUTPUT
#include <openvdb/tools/LevelSetMeasure.h>
#include <openvdb/tools/LevelSetMorph.h>

#include <cmath>

#include "driver.h"
#include "mesh_file.h"
#include "openvdb_surface.h"

using namespace transformesh;
using openvdb::FloatGrid;

namespace {

constexpr int most_rounds = 2000;
/// The morph ends if a round changes the volume by less than this share. A larger share ends
/// sooner, farther from the target.
constexpr double rest = 1e-6;

void morph(FloatGrid& grid, const FloatGrid& target) {
  openvdb::tools::LevelSetMorphing<FloatGrid> morphing(grid, target);
  // These are the fastest schemes: TVD_RK2 allows steps three times as long as TVD_RK1. The final
  // state, at which the speed is zero, depends neither on these schemes nor on the renormalization.
  morphing.setSpatialScheme(openvdb::math::FIRST_BIAS);
  morphing.setTemporalScheme(openvdb::math::TVD_RK2);
  morphing.setTrackerSpatialScheme(openvdb::math::FIRST_BIAS);
  morphing.setTrackerTemporalScheme(openvdb::math::TVD_RK1);
  morphing.setNormCount(1);
  double volume = openvdb::tools::levelSetVolume(grid);
  for (int round = 0; round < most_rounds; ++round) {
    morphing.advect(static_cast<float>(round), static_cast<float>(round + 1));
    const double next = openvdb::tools::levelSetVolume(grid);
    if (std::abs(next - volume) < rest * std::abs(next)) return;
    volume = next;
  }
}

void measure(double voxel, const std::string& source, const std::string& target,
             const std::string& output) {
  const Mesh from = read_file(source);
  const Mesh to = read_file(target);
  const OneThread one_thread;
  time_surface(output, [&] {
    const FloatGrid::Ptr grid = level_set(from, voxel);
    morph(*grid, *level_set(to, voxel));
    return grid;
  });
}

}  // namespace

int main(int argc, char** argv) {
  return drive(
      {argv, static_cast<std::size_t>(argc)}, "openvdb-morph VOXEL SOURCE TARGET OUTPUT",
      [](const auto& words) { measure(std::stod(words[0]), words[1], words[2], words[3]); });
}
