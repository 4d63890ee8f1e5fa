/// Triangle meshes of the chain corpus: plain arrays, read and written without the library, so that
/// a fault of its readers cannot go unnoticed.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace chains {

using Point = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

enum class Type { float32, float64 };

/// Rounds to float and back. g++ 12 optimizes away a pair of casts in loops over several
/// coordinates.
inline double rounded_to_float(double x) {
  // volatile prevents that the casts are optimized away
  const volatile auto single = static_cast<float>(x);
  return single;
}

struct TriangleMesh {
  std::vector<Point> points;
  std::vector<Triangle> faces;
  Type type = Type::float64;  ///< scalar type of the coordinates in the file
};

/// Reads PLY (ASCII and binary in both byte orders), OFF and binary STL; the corners of STL stay
/// separate. Throws std::runtime_error if the bytes are none of these, end early, or contain a face
/// that is not a triangle. Indices are not checked.
TriangleMesh read_mesh(const std::string& bytes);

/// Returns the mesh as binary little-endian PLY with the mesh's scalar type.
std::string write_ply(const TriangleMesh& mesh);

/// Appends the points and faces of `other`; reverses its faces if `is_flipped`.
void append(TriangleMesh& mesh, const TriangleMesh& other, bool is_flipped = false);

/// Returns the length of the diagonal of the bounding box; 0 for a mesh without points.
double diagonal(const TriangleMesh& mesh);

/// Returns the largest magnitude of a coordinate.
double largest_coordinate(const TriangleMesh& mesh);

}  // namespace chains
