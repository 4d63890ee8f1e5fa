#include "transformesh/measure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/edges.h"
#include "mesh/length_of.h"
#include "mesh/local_measures.h"
#include "mesh/triangle.h"
#include "support/elementary/arctangent.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr double degrees_per_radian = 180 / std::numbers::pi;  ///< converts angles
constexpr std::size_t faces_per_task = 4096;                   ///< affects time only

/// If the sizes of coordinates are in this range, squares and products of three coordinates neither
/// overflow nor vanish.
constexpr double large = 1e60;
constexpr double small = 1e-60;

/// Returns the angle between two vectors, in [0, pi]; accurate near 0 and pi.
double angle_between(const Vec3& u, const Vec3& v) {
  return elementary::atan2(u.cross(v).norm(), u.dot(v));
}

double corner_angle(const Mesh& mesh, const Face& face, int corner) {
  const Vec3& apex = mesh.positions[face[corner]];
  return angle_between(mesh.positions[face[(corner + 1) % 3]] - apex,
                       mesh.positions[face[(corner + 2) % 3]] - apex);
}

/// Returns the angle opposite to the shortest edge, which is the smallest angle.
double smallest_angle(const Mesh& mesh, const Face& face) {
  int apex = 0;
  double shortest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double across =
        (mesh.positions[face[(i + 2) % 3]] - mesh.positions[face[(i + 1) % 3]]).squaredNorm();
    if (across < shortest) {
      shortest = across;
      apex = i;
    }
  }
  return corner_angle(mesh, face, apex);
}

// These functions take values, unlike std::min, which takes references, and compile to single
// instructions.
double lesser(double a, double b) { return a < b ? a : b; }
double greater(double a, double b) { return a > b ? a : b; }

/// Extends a box by three points. Finds the extremes of the three points first. In a loop over
/// faces, each box then waits for the previous box for only one comparison.
void extend(Box& box, const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int axis = 0; axis < 3; ++axis) {
    const double low = lesser(lesser(a[axis], b[axis]), c[axis]);
    const double high = greater(greater(a[axis], b[axis]), c[axis]);
    box.min()[axis] = lesser(low, box.min()[axis]);
    box.max()[axis] = greater(high, box.max()[axis]);
  }
}

}  // namespace

int extreme_exponent(const Mesh& mesh) {
  double largest = 0;
  for (const Vec3& point : mesh.positions)
    largest = std::max(largest, point.lpNorm<Eigen::Infinity>());
  const bool is_extreme = largest > large || (largest > 0 && largest < small);
  return is_extreme ? std::ilogb(largest) : 0;
}

Mesh scaled_down(const Mesh& mesh, int exponent) {
  Mesh scaled;
  scaled.faces = mesh.faces;
  scaled.positions.reserve(mesh.positions.size());
  for (const Vec3& point : mesh.positions)
    scaled.positions.emplace_back(
        point.unaryExpr([&](double x) { return std::ldexp(x, -exponent); }));
  return scaled;
}

double diagonal_of(const Box& box) { return box.isEmpty() ? 0 : length_of(box.max() - box.min()); }

Vec3 direction_into_face(const Mesh& mesh, Index halfedge) {
  const Vec3& from = mesh.positions[halfedge_source(mesh, halfedge)];
  const Vec3& apex = mesh.positions[halfedge_source(mesh, previous_halfedge(halfedge))];
  const Vec3 along = (mesh.positions[halfedge_target(mesh, halfedge)] - from).stableNormalized();
  const Vec3 inwards = (apex - from).stableNormalized();
  return (inwards - inwards.dot(along) * along).stableNormalized();
}

std::vector<Vec3> used_positions(const Mesh& mesh) {
  std::vector<bool> is_used(mesh.positions.size(), false);
  for (const Face& face : mesh.faces)
    for (const Index vertex : face) is_used[vertex] = true;
  std::vector<Vec3> positions;
  for (std::size_t v = 0; v < is_used.size(); ++v)
    if (is_used[v]) positions.push_back(mesh.positions[v]);
  return positions;
}

Box bounding_box(const Mesh& mesh) {
  if (mesh.positions.empty()) return Box(Vec3::Zero(), Vec3::Zero());
  const Vec3& first = mesh.positions[mesh.faces.empty() ? 0 : mesh.faces[0][0]];
  Box box{first, first};
  for (const auto& [a, b, c] : mesh.faces)
    extend(box, mesh.positions[a], mesh.positions[b], mesh.positions[c]);
  if (mesh.faces.empty())
    for (const Vec3& point : mesh.positions) extend(box, point, point, point);
  return box;
}

Vec3 face_normal(const Mesh& mesh, Index face) {
  const auto& [a, b, c] = mesh.faces[face];
  return normal_of(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
}

double face_area(const Mesh& mesh, Index face) { return length_of(face_normal(mesh, face)) / 2; }

std::vector<double> vertex_areas(const Mesh& mesh) {
  std::vector<double> areas(mesh.positions.size(), 0);
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (const Index vertex : mesh.faces[f]) areas[vertex] += face_area(mesh, f) / 3;
  return areas;
}

double surface_area(const Mesh& mesh) {
  if (const int exponent = extreme_exponent(mesh); exponent != 0)
    return std::ldexp(surface_area(scaled_down(mesh, exponent)), 2 * exponent);
  double area = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    area += face_area(mesh, static_cast<Index>(f));
  return area;
}

double volume(const Mesh& mesh) {
  if (const int exponent = extreme_exponent(mesh); exponent != 0)
    return std::ldexp(volume(scaled_down(mesh, exponent)), 3 * exponent);
  // The apex of all tetrahedra is the center of the mesh. With a distant apex, their volumes would
  // cancel and lose digits.
  const Box box = bounding_box(mesh);
  const Vec3 apex = box.min() + (box.max() - box.min()) / 2;
  double sum = 0;
  for (const Face& face : mesh.faces) {
    const Vec3 a = mesh.positions[face[0]] - apex;
    const Vec3 b = mesh.positions[face[1]] - apex;
    const Vec3 c = mesh.positions[face[2]] - apex;
    sum += a.dot(b.cross(c));
  }
  return sum / 6;
}

EdgeLengths edge_lengths(const Mesh& mesh) {
  if (const int exponent = extreme_exponent(mesh); exponent != 0) {
    EdgeLengths lengths = edge_lengths(scaled_down(mesh, exponent));
    for (double* length : {&lengths.mean, &lengths.minimum, &lengths.maximum})
      *length = std::ldexp(*length, exponent);
    return lengths;
  }
  const Edges edges(mesh);
  EdgeLengths result;
  result.count = edges.size();
  if (result.count == 0) return result;
  result.minimum = std::numeric_limits<double>::infinity();
  double sum = 0;
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    const Index halfedge = edges.halfedges(edge)[0];
    const double length = (mesh.positions[halfedge_source(mesh, halfedge)] -
                           mesh.positions[halfedge_target(mesh, halfedge)])
                              .norm();
    sum += length;
    result.minimum = std::min(result.minimum, length);
    result.maximum = std::max(result.maximum, length);
  }
  result.mean = sum / static_cast<double>(result.count);
  return result;
}

HalfedgeLengths halfedge_lengths(const Mesh& mesh) {
  HalfedgeLengths result;
  result.vertex_mean.assign(mesh.positions.size(), 0);
  std::vector<Index> counts(mesh.positions.size(), 0);
  double total = 0;
  for (const Face& face : mesh.faces) {
    for (int i = 0; i < 3; ++i) {
      const Index a = face[i];
      const Index b = face[(i + 1) % 3];
      const double length = (mesh.positions[b] - mesh.positions[a]).norm();
      total += length;
      result.maximum = std::max(result.maximum, length);
      for (const Index end : {a, b}) {
        result.vertex_mean[end] += length;
        ++counts[end];
      }
    }
  }
  for (std::size_t v = 0; v < counts.size(); ++v) {
    if (counts[v] > 0) result.vertex_mean[v] /= counts[v];
  }
  if (!mesh.faces.empty()) result.mean = total / (3 * static_cast<double>(mesh.faces.size()));
  return result;
}

Angles angles(const Mesh& mesh) {
  if (mesh.faces.empty()) return {};
  if (const int exponent = extreme_exponent(mesh); exponent != 0)
    return angles(scaled_down(mesh, exponent));
  std::vector<double> smallest(mesh.faces.size());
  parallel_for(mesh.faces.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) smallest[f] = smallest_angle(mesh, mesh.faces[f]);
  });
  double sum = 0;
  for (const double angle : smallest) sum += angle;
  return {*std::min_element(smallest.begin(), smallest.end()) * degrees_per_radian,
          sum / static_cast<double>(smallest.size()) * degrees_per_radian};
}

std::vector<Vec3> vertex_normals(const Mesh& mesh) {
  if (const int exponent = extreme_exponent(mesh); exponent != 0)
    return vertex_normals(scaled_down(mesh, exponent));
  struct Weighted {
    Vec3 unit;
    std::array<double, 3> angles;
  };
  std::vector<Weighted> weighted(mesh.faces.size());
  parallel_for(mesh.faces.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      weighted[f].unit = face_normal(mesh, static_cast<Index>(f)).stableNormalized();
      for (int i = 0; i < 3; ++i) weighted[f].angles[i] = corner_angle(mesh, mesh.faces[f], i);
    }
  });
  std::vector<Vec3> normals(mesh.positions.size(), Vec3::Zero());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (int i = 0; i < 3; ++i)
      normals[mesh.faces[f][i]] += weighted[f].angles[i] * weighted[f].unit;
  parallel_for(normals.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) normals[v] = normals[v].stableNormalized();
  });
  return normals;
}

Vec3 vertex_normal(const Mesh& mesh, Index vertex, std::span<const Index> faces) {
  Vec3 normal = Vec3::Zero();
  for (const Index face : faces) {
    const Vec3 unit = face_normal(mesh, face).stableNormalized();
    for (int i = 0; i < 3; ++i)
      if (mesh.faces[face][i] == vertex) normal += corner_angle(mesh, mesh.faces[face], i) * unit;
  }
  return normal.stableNormalized();
}

double valence_six_share(const Mesh& mesh) {
  const Edges edges(mesh);
  std::vector<Index> valence(mesh.positions.size(), 0);
  std::vector<bool> is_border(mesh.positions.size(), false);
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    const auto halfedges = edges.halfedges(edge);
    for (const Index vertex :
         {halfedge_source(mesh, halfedges[0]), halfedge_target(mesh, halfedges[0])}) {
      ++valence[vertex];
      if (halfedges.size() == 1) is_border[vertex] = true;
    }
  }

  std::size_t interior = 0;
  std::size_t six = 0;
  for (std::size_t v = 0; v < valence.size(); ++v) {
    if (valence[v] == 0 || is_border[v]) continue;
    ++interior;
    if (valence[v] == 6) ++six;
  }
  return interior == 0 ? 0 : static_cast<double>(six) / static_cast<double>(interior);
}

}  // namespace transformesh
