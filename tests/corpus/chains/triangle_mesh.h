/// Triangle meshes of the chain corpus: plain arrays, read and written without the library, so that
/// a fault of its readers cannot hide here.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace chains {

using Point = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

enum class Type { float32, float64 };

/// Rounds to float and back. g++ 12 drops a pair of casts in loops over several coordinates.
inline double rounded_to_float(double x) {
  const volatile auto single = static_cast<float>(x);  // volatile: the casts must happen
  return single;
}

struct TriangleMesh {
  std::vector<Point> points;
  std::vector<Triangle> faces;
  Type type = Type::float64;  ///< scalar type of the coordinates in the file
};

/// Reads PLY (ASCII and binary of either byte order), OFF and binary STL, whose corners stay apart.
/// Throws std::runtime_error if the bytes are none of these, end early, or hold a face that is no
/// triangle. Indices are not checked.
TriangleMesh read_mesh(const std::string& bytes);

/// Binary little-endian PLY in the mesh's type.
std::string write_ply(const TriangleMesh& mesh);

/// Appends the points and faces of `other`; if `is_flipped`, its faces are reversed.
void append(TriangleMesh& mesh, const TriangleMesh& other, bool is_flipped = false);

/// Length of the diagonal of the bounding box; 0 for a mesh without points.
double diagonal(const TriangleMesh& mesh);

/// Largest magnitude of a coordinate.
double largest_coordinate(const TriangleMesh& mesh);

}  // namespace chains
