// mesh-error X Y Z RADIUS MESH
//
// Measures of a closed mesh by arithmetic that shares nothing with the library. Prints volume,
// area, and the exact distances of mesh points from the sphere with center X Y Z and RADIUS.
// `encloses` is the winding number of the mesh at the center. If it is 1, every ray from the center
// meets the mesh. In this case, the largest distance of mesh points from the sphere is also an
// upper bound of the distance of sphere points from the mesh.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "driver.h"
#include "mesh_file.h"

using namespace transformesh;

namespace {

struct Sphere {
  Vec3 center;
  double radius;
};

struct Measures {
  double volume = 0, area = 0, farthest = 0, squares = 0, solid_angle = 0;
};

/// Returns the solid angle of a face as seen from the point (0, 0, 0). Reference: van Oosterom &
/// Strackee, "The solid angle of a plane triangle", IEEE Transactions on Biomedical Engineering 30,
/// 1983.
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)),
                        la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

/// Adds the distances from the sphere at 28 points of a face, in a triangular grid. Therefore the
/// interior of the face counts, and not only its corners.
void add_distances(const Vec3& a, const Vec3& b, const Vec3& c, double radius, double area,
                   Measures& sums) {
  constexpr int parts = 6, points = (parts + 1) * (parts + 2) / 2;
  for (int i = 0; i <= parts; ++i) {
    for (int j = 0; i + j <= parts; ++j) {
      const Vec3 point = (i * a + j * b + (parts - i - j) * c) / parts;
      const double distance = std::abs(point.norm() - radius);
      sums.farthest = std::max(sums.farthest, distance);
      sums.squares += area * distance * distance / points;
    }
  }
}

Measures measures(const Mesh& mesh, const Sphere& sphere) {
  Measures sums;
  for (const auto& [i, j, k] : mesh.faces) {
    const Vec3 a = mesh.positions[i] - sphere.center, b = mesh.positions[j] - sphere.center,
               c = mesh.positions[k] - sphere.center;
    const double area = (b - a).cross(c - a).norm() / 2;
    sums.volume += a.dot(b.cross(c)) / 6;
    sums.area += area;
    sums.solid_angle += solid_angle(a, b, c);
    add_distances(a, b, c, sphere.radius, area, sums);
  }
  return sums;
}

void measure(const Sphere& sphere, const std::string& path) {
  const Measures sums = measures(read_file(path), sphere);
  std::cout.precision(12);
  std::cout << "volume: " << sums.volume << "\narea: " << sums.area
            << "\nhausdorff: " << sums.farthest << "\nrms: " << std::sqrt(sums.squares / sums.area)
            << "\nencloses: " << std::lround(sums.solid_angle / (4 * std::numbers::pi)) << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  return drive({argv, static_cast<std::size_t>(argc)}, "mesh-error X Y Z RADIUS MESH",
               [](const auto& words) {
                 const Vec3 center(std::stod(words[0]), std::stod(words[1]), std::stod(words[2]));
                 measure({center, std::stod(words[3])}, words[4]);
               });
}
