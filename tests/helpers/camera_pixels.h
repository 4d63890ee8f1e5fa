/// Pixels of known points, and damaged files, for tests of camera formats.
#pragma once

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "helpers/random.h"
#include "transformesh/errors.h"
#include "views/cameras/camera_file.h"

namespace transformesh::test {

/// A pose in general position. Maps world coordinates to camera coordinates: x right, y down, z
/// forward.
struct TruePose {
  Eigen::Matrix3d rotation = Eigen::AngleAxisd(0.7, Vec3(1, 2, -2) / 3).toRotationMatrix();
  Vec3 center{0.3, -0.4, -5};

  Vec3 translation() const { return -rotation * center; }
  /// Coordinates of a point divided by its depth.
  Eigen::Vector2d on_plane(const Vec3& point) const {
    return (rotation * (point - center)).hnormalized();
  }
  /// 20 points in front of the camera.
  std::vector<Vec3> points() const {
    Random random(7);
    std::vector<Vec3> points;
    for (int i = 0; i < 20; ++i) {
      const Vec3 local(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(3, 9));
      points.push_back(rotation.transpose() * local + center);
    }
    return points;
  }
};

inline std::string exact(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

/// Returns the coefficients of a matrix as text, row by row, with a separator between them.
inline std::string joined(const Eigen::MatrixXd& matrix, const std::string& separator) {
  std::string text;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      text += (text.empty() ? "" : separator) + exact(matrix(i, j));
  return text;
}

inline Eigen::Vector2d pixel_of(const CameraRecord& record, const Vec3& point) {
  const Vec3 local = record.camera.rotation * point + record.camera.translation;
  const Eigen::Vector2d bent =
      record.distortion.distorted(local.x() / local.z(), local.y() / local.z());
  return (record.camera.intrinsics * bent.homogeneous()).hnormalized();
}

/// Checks the pixels to which `record` projects 20 points. `expected` takes the coordinates of a
/// point on the plane at depth 1, and returns the pixel of the point.
inline void check_pixels(const CameraRecord& record,
                         const std::function<Eigen::Vector2d(double x, double y)>& expected) {
  const TruePose pose;
  for (const Vec3& point : pose.points()) {
    const Eigen::Vector2d plane = pose.on_plane(point);
    CHECK((pixel_of(record, point) - expected(plane.x(), plane.y())).norm() < 1e-6);
  }
}

/// Checks that each damaged copy of a file is read as valid cameras, or refused with a message that
/// names the file.
inline void check_damaged(const std::string& bytes, int rounds = 1500) {
  Random random(4);
  const std::string_view replacements("\0 \n{}[],:\"-.0e9n\xff", 18);
  for (int round = 0; round < rounds; ++round) {
    std::string damaged =
        bytes.substr(0, round % 3 == 0 ? random.below(bytes.size()) : bytes.size());
    for (int i = 0; i < round % 4 && !damaged.empty(); ++i)
      damaged[random.below(damaged.size())] = replacements[random.below(replacements.size())];
    try {
      for (const CameraRecord& record : parse_cameras(damaged, "some.file").cameras) {
        CHECK(record.camera.projection().allFinite());
        CHECK(record.camera.rotation.determinant() == doctest::Approx(1).epsilon(1e-2));
        CHECK(record.camera.intrinsics.diagonal().minCoeff() > 0);
      }
    } catch (const InputError& error) {
      CHECK(std::string(error.what()).find("some.file") != std::string::npos);
    }
  }
}

/// Checks that the file is refused, and that the message contains these words and names the file.
inline bool refuses(const std::string& bytes, const std::string& words) {
  std::string message;
  try {
    parse_cameras(bytes, "some.file");
  } catch (const InputError& error) {
    message = error.what();
  }
  INFO(message);
  CHECK(message.find("some.file") != std::string::npos);
  CHECK(message.find(words) != std::string::npos);
  return message.find(words) != std::string::npos;
}

}  // namespace transformesh::test
