#include "clean/box/box_submesh.h"

#include <bit>

#include "geometry/numbers/predicates.h"
#include "mesh/coordinate_spacing.h"

namespace transformesh {
namespace {

/// Size of the hash set in bits, divided by the number of faces whose vertices are added. With more
/// bits, fewer positions that were not added are reported as contained.
constexpr std::size_t bits_per_position = 64;

std::uint64_t mixed(std::uint64_t h) {
  h *= 0xff51afd7ed558ccdULL;
  h ^= h >> 32;
  h *= 0xc4ceb9fe1a85ec53ULL;
  return h ^ (h >> 29);
}

std::uint64_t hash_of(const Vec3& p) {
  std::uint64_t h = 0x9e3779b97f4a7c15ULL;
  for (int i = 0; i < 3; ++i)
    h = mixed(h ^ std::bit_cast<std::uint64_t>(p[i] + 0.0));  // adding 0 turns -0 into 0
  return h;
}

/// Approximate set of positions, stored as bits at their hashes. A test for an added position is
/// always true; a test for another position is rarely true.
class RoughPositions {
 public:
  explicit RoughPositions(std::size_t count)
      : bits_(std::bit_ceil(bits_per_position * count + 1), false) {}
  void add(const Vec3& position) { bits_[place(position)] = true; }
  bool has(const Vec3& position) const { return bits_[place(position)]; }

 private:
  std::size_t place(const Vec3& position) const { return hash_of(position) & (bits_.size() - 1); }
  std::vector<bool> bits_;
};

}  // namespace

std::vector<bool> faces_of_box(const Mesh& mesh, const Box& box) {
  std::vector<bool> result(mesh.faces.size());
  for (std::size_t f = 0; f < result.size(); ++f) {
    const Vec3& first = mesh.positions[mesh.faces[f][0]];
    result[f] =
        (first.array() >= box.min().array()).all() && (first.array() < box.max().array()).all();
  }
  return result;
}

Box box_around(const Mesh& mesh, const std::vector<bool>& faces) {
  constexpr double largest = std::numeric_limits<double>::max();
  Box box{Vec3::Constant(largest), Vec3::Constant(-largest)};
  for (Index f = 0; f < faces.size(); ++f) {
    if (!faces[f]) continue;
    for (const Index v : mesh.faces[f]) {
      box.min() = box.min().cwiseMin(mesh.positions[v]);
      box.max() = box.max().cwiseMax(mesh.positions[v]);
    }
  }
  return box;
}

Box first_vertices(const Mesh& mesh, const std::vector<bool>& faces) {
  Box box;
  for (Index f = 0; f < faces.size(); ++f)
    if (faces[f]) box.extend(mesh.positions[mesh.faces[f][0]]);
  return box;
}

double margin_around(const Box& box, Scalar coordinate) {
  // In spacings of floating-point numbers. Chosen by hand, far above the spacings by which rounding
  // moves vertices; not measured.
  constexpr double margin_spacings = 64;
  const Vec3 farthest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs());
  return margin_spacings * spacing_around(farthest, coordinate);
}

Box with_margin(const Box& box, Scalar coordinate) {
  const double margin = margin_around(box, coordinate);
  return {box.min().array() - margin, box.max().array() + margin};
}

std::vector<bool> faces_near(const Mesh& mesh, const Box& box) {
  const Vec3 &low = box.min(), &high = box.max();
  std::vector<bool> result(mesh.faces.size());
  for (Index f = 0; f < result.size(); ++f) {
    const Triangle t = triangle_of(mesh, f);
    result[f] = (t[0].cwiseMin(t[1]).cwiseMin(t[2]).array() <= high.array()).all() &&
                (t[0].cwiseMax(t[1]).cwiseMax(t[2]).array() >= low.array()).all();
  }
  return result;
}

BoxSubmesh take_submesh(const Mesh& mesh, const std::vector<bool>& faces) {
  BoxSubmesh part;
  std::vector<bool> is_taken(mesh.positions.size(), false);
  for (Index f = 0; f < faces.size(); ++f) {
    if (!faces[f]) continue;
    part.face_of.push_back(f);
    for (const Index v : mesh.faces[f]) is_taken[v] = true;
  }
  RoughPositions taken(part.face_of.size());
  for (Index v = 0; v < is_taken.size(); ++v)
    if (is_taken[v]) taken.add(mesh.positions[v]);

  std::vector<Index> vertices;
  std::vector<Index> number_of(mesh.positions.size(), no_index);
  for (Index v = 0; v < number_of.size(); ++v) {
    if (!is_taken[v] && !taken.has(mesh.positions[v])) continue;
    number_of[v] = static_cast<Index>(vertices.size());
    vertices.push_back(v);
  }
  part.mesh.positions.reserve(vertices.size());
  for (const Index v : vertices) part.mesh.positions.push_back(mesh.positions[v]);
  part.mesh.faces.reserve(part.face_of.size());
  for (const Index f : part.face_of) {
    const auto& [a, b, c] = mesh.faces[f];
    part.mesh.faces.push_back({number_of[a], number_of[b], number_of[c]});
  }
  part.mesh.vertex_columns = mesh.vertex_columns.select(vertices);
  part.mesh.face_columns = mesh.face_columns.select(part.face_of);
  return part;
}

void FaceSums::add(const Triangle& t) {
  const auto edge = [](std::uint64_t from, std::uint64_t to) { return mixed(from ^ (3 * to)); };
  const std::array h{hash_of(t[0]), hash_of(t[1]), hash_of(t[2])};
  for (const std::uint64_t corner : h) faces_ = mixed(faces_ ^ corner) + 1;
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] || collinear(t[0], t[1], t[2])) return;
  for (std::size_t i = 0; i < 3; ++i)
    edges_ += edge(h[i], h[(i + 1) % 3]) - edge(h[(i + 1) % 3], h[i]);
}

FaceSums face_sums(const Mesh& mesh) {
  FaceSums sums;
  for (Index f = 0; f < mesh.faces.size(); ++f) sums.add(triangle_of(mesh, f));
  return sums;
}

}  // namespace transformesh
