#include "helpers/winding_oracle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "geometry/solid_angle_winding.h"
#include "helpers/random.h"
#include "support/parallel.h"
#include "transformesh/measure.h"

namespace transformesh::test {
namespace {

Vec3 point_in_box(const Box& box, Random& random) {
  return box.min() + random.point(0, 1).cwiseProduct(box.max() - box.min());
}

Vec3 point_in_face(const Mesh& mesh, const Face& face, Random& random) {
  double u = random.uniform(0, 1);
  double v = random.uniform(0, 1);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const Vec3& a = mesh.positions[face[0]];
  return a + u * (mesh.positions[face[1]] - a) + v * (mesh.positions[face[2]] - a);
}

/// Adds six points in front of and behind a random point of a random face.
void add_points_near_face(const Mesh& mesh, Random& random, std::vector<Vec3>& points) {
  const Index f = static_cast<Index>(random.below(mesh.faces.size()));
  const Face& face = mesh.faces[f];
  const Vec3 base = point_in_face(mesh, face, random);
  const Vec3 unit = face_normal(mesh, f).stableNormalized();
  double edge_sum = 0;
  for (int i = 0; i < 3; ++i)
    edge_sum += (mesh.positions[face[i]] - mesh.positions[face[(i + 1) % 3]]).norm();
  for (const double offset : {1e-3, 1e-2, 1e-1})
    for (const double side : {-1.0, 1.0})
      points.push_back(base + side * offset * edge_sum / 3 * unit);
}

std::vector<Vec3> draw_samples(const Mesh& input, const Mesh& output,
                               const WindingOracleOptions& options) {
  Box box = bounding_box(input);
  const Vec3 margin = 0.1 * (box.max() - box.min());
  box = {box.min() - margin, box.max() + margin};

  Random random(options.seed);
  std::vector<Vec3> points;
  while (points.size() < options.samples / 2) points.push_back(point_in_box(box, random));
  while (points.size() < options.samples) {
    if (!input.faces.empty()) add_points_near_face(input, random, points);
    if (!output.faces.empty()) add_points_near_face(output, random, points);
    if (input.faces.empty() && output.faces.empty()) points.push_back(point_in_box(box, random));
  }
  return points;
}

/// Tests whether a point is near a face. Planes and boxes of the faces exclude far points quickly.
class NearFaces {
 public:
  NearFaces(const Mesh& mesh, double distance) : distance_(distance) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const auto& [a, b, c] = mesh.faces[f];
      const Vec3 margin = Vec3::Constant(distance);
      const Vec3& p = mesh.positions[a];
      const Vec3& q = mesh.positions[b];
      const Vec3& r = mesh.positions[c];
      slabs_.push_back({p.cwiseMin(q).cwiseMin(r) - margin, p.cwiseMax(q).cwiseMax(r) + margin, p,
                        face_normal(mesh, static_cast<Index>(f)).stableNormalized()});
    }
  }

  /// True if the point is closer to a face than the distance. May also be true for points that are
  /// a little farther from the edges of a face.
  bool contain(const Vec3& point) const {
    return std::any_of(slabs_.begin(), slabs_.end(), [&](const Slab& slab) {
      return (point.array() >= slab.minimum.array()).all() &&
             (point.array() <= slab.maximum.array()).all() &&
             std::abs(slab.normal.dot(point - slab.corner)) <= distance_;
    });
  }

 private:
  struct Slab {
    Vec3 minimum, maximum, corner, normal;
  };
  std::vector<Slab> slabs_;
  double distance_;
};

std::vector<char> mark_near(const Mesh& mesh, const std::vector<Vec3>& points, double distance) {
  const NearFaces near(mesh, distance);
  std::vector<char> marks(points.size());
  parallel_for(points.size(), 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) marks[i] = near.contain(points[i]);
  });
  return marks;
}

double largest_coordinate(const Mesh& mesh) {
  const Box box = bounding_box(mesh);
  return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
}

}  // namespace

WindingOracleResult compare_windings(const Mesh& input, const Mesh& output,
                                     const WindingOracleOptions& options) {
  const std::vector<Vec3> points = draw_samples(input, output, options);
  const double distance = options.tolerance * largest_coordinate(input);
  const std::vector<char> is_near_input = mark_near(input, points, distance);
  const std::vector<char> is_near_output = mark_near(output, points, distance);
  const std::vector<BoundedWindingNumber> input_windings = SolidAngleWinding(input)(points);
  const std::vector<BoundedWindingNumber> output_windings = SolidAngleWinding(output)(points);

  WindingOracleResult result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const BoundedWindingNumber& in = input_windings[i];
    const BoundedWindingNumber& out = output_windings[i];
    // An output that is not closed has fractional winding numbers. These count as wrong, not as
    // undecided.
    if (is_near_input[i] || is_near_output[i] || !in.is_decided() || out.error >= 0.25) {
      ++result.undecided;
      continue;
    }
    ++result.tested;
    const int expected = in.rounded() >= options.winding_level ? 1 : 0;
    if (std::abs(out.number - expected) <= out.error) continue;
    if (result.wrong++ > 0) continue;
    result.wrong_point = points[i];
    result.wrong_input_winding = in.number;
    result.wrong_output_winding = out.number;
  }
  return result;
}

std::string describe(const WindingOracleResult& result) {
  std::ostringstream text;
  text << "tested " << result.tested << " wrong " << result.wrong << " undecided "
       << result.undecided;
  text.precision(17);
  if (result.wrong > 0)
    text << "\nfirst wrong at " << result.wrong_point.transpose() << ": winding number "
         << result.wrong_input_winding << " in the input, " << result.wrong_output_winding
         << " in the output";
  return text.str();
}

}  // namespace transformesh::test
