/// Converts between meshes and level sets of OpenVDB.
#pragma once

#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/VolumeToMesh.h>
#include <tbb/global_control.h>

#include <ctime>
#include <iostream>
#include <string>
#include <vector>

#include "mesh_file.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Returns signed distances in a band of three voxels on both sides of a closed mesh.
inline openvdb::FloatGrid::Ptr level_set(const Mesh& mesh, double voxel) {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  for (const Vec3& p : mesh.positions)
    points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()),
                        static_cast<float>(p.z()));
  for (const auto& [a, b, c] : mesh.faces) triangles.emplace_back(a, b, c);
  return openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(
      *openvdb::math::Transform::createLinearTransform(voxel), points, triangles);
}

/// Returns the zero level set, oriented outwards.
inline Mesh surface(const openvdb::FloatGrid& grid) {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec4I> quads;
  openvdb::tools::volumeToMesh(grid, points, quads);
  Mesh mesh;
  for (const auto& p : points) mesh.positions.emplace_back(p.x(), p.y(), p.z());
  for (const auto& q : quads) {  // corners are clockwise as seen from outside
    mesh.faces.push_back({q[0], q[2], q[1]});
    mesh.faces.push_back({q[0], q[3], q[2]});
  }
  return mesh;
}

/// While an object of this class exists, OpenVDB uses one thread. More threads would spend CPU time
/// on waiting.
class OneThread {
 public:
  OneThread() { openvdb::initialize(); }

 private:
  tbb::global_control limit_{tbb::global_control::max_allowed_parallelism, 1};
};

/// Writes the surface of the level set that `body` returns, and prints the CPU seconds of `body`
/// and of meshing.
template <typename Body>
void time_surface(const std::string& output, const Body& body) {
  const std::clock_t start = std::clock();
  const Mesh result = surface(*body());
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  write_file(output, result);
  std::cout << "seconds: " << seconds << '\n';
}

}  // namespace transformesh
