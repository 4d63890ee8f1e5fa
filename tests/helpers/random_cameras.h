/// Random cameras, for tests of camera files.
#pragma once

#include <Eigen/Geometry>

#include "helpers/random.h"
#include "raster/camera_record.h"

namespace transformesh::test {

inline PinholeCamera random_camera(Random& random) {
  PinholeCamera camera;
  camera.intrinsics << random.uniform(200, 4000), 0, random.uniform(100, 900), 0,
      random.uniform(200, 4000), random.uniform(100, 900), 0, 0, 1;
  const double angle = random.uniform(0, 3);
  camera.rotation = Eigen::AngleAxisd(angle, random.point(-1, 1).normalized()).toRotationMatrix();
  camera.translation = random.point(-3, 3);
  return camera;
}

inline CameraList random_cameras(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  CameraList list;
  list.names_images = true;
  for (std::size_t i = 0; i < count; ++i) {
    CameraRecord record;
    record.name = "view" + std::to_string(i) + ".png";
    record.camera = random_camera(random);
    record.width = 640;
    record.height = 480;
    list.cameras.push_back(record);
  }
  return list;
}

}  // namespace transformesh::test
