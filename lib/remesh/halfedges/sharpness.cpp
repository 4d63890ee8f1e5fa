#include "remesh/halfedges/sharpness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/elementary/arctangent.h"
#include "support/elementary/trigonometric.h"

namespace transformesh {
namespace {

/// A face has a reliable normal if its height is above this many spacings of its coordinates:
/// rounding then rotates the normal by less than 4 degrees.
constexpr double steady_spacings = 16;
/// Least angles between the normals of two faces at which their edge counts as sharp, and as a
/// line. Sharp edges are lines, too.
constexpr double sharp_deg = 60;
constexpr double line_deg = 40;
/// A sharp edge is intended, and not noise, if the surface beside it is smooth. For this, the edges
/// at its ends that are not lines must turn by less than this share of the turn of the sharp edge.
/// Edges between the sides of a hole with 9 to 11 sides turn by 33 to 40 degrees and are no lines.
/// The edge between the hole and a plate turns by 90 degrees. With a share below 40/90 it would
/// count as noise.
constexpr double smooth_share = 0.45;
/// A mesh has sharp edges if the length of intended edges exceeds these shares of the length of all
/// sharp edges and of all lines. With larger shares, features of noisy meshes are missed; with
/// smaller shares, noise passes for features.
constexpr double meant_share = 0.9;
constexpr double meant_of_lines = 0.25;
/// The total length of intended sharp edges (those that are no noise) must exceed this multiple of
/// the square root of the surface's area.
constexpr double least_length = 0.5;

double cosine_of(double degrees) { return elementary::cos(degrees * std::numbers::pi / 180); }

/// Returns the angle with this cosine, in radians.
double angle_of(double cosine) {
  return elementary::atan2(std::sqrt(std::max(0.0, 1 - cosine * cosine)), cosine);
}

Index longest_halfedge(const EditableMesh& mesh, Index face) {
  Index longest = 3 * face;
  for (Index h = 3 * face + 1; h < 3 * face + 3; ++h)
    if (mesh.squared_length(h) > mesh.squared_length(longest)) longest = h;
  return longest;
}

double spacing_at_face(const EditableMesh& mesh, Index face) {
  double spacing = 0;
  for (Index h = 3 * face; h < 3 * face + 3; ++h)
    spacing = std::max(spacing, spacing_around(mesh.position(mesh.source(h)), mesh.coordinate()));
  return spacing;
}

/// Returns the unit normal of a face, or zero if the face is too thin for a reliable normal.
Vec3 own_normal(const EditableMesh& mesh, Index face) {
  const Vec3 normal = mesh.face_normal(face);
  const double area = normal.stableNorm();
  const double height = area / std::sqrt(mesh.squared_length(longest_halfedge(mesh, face)));
  const bool is_steady = height > steady_spacings * spacing_at_face(mesh, face);
  return is_steady ? Vec3(normal / area) : Vec3(Vec3::Zero());
}

/// Follows longest edges from each thin face to a face with a normal, which all faces on the path
/// then take. A path that ends in a cycle yields no normal, for example if two thin faces share
/// their longest edge.
void take_over_across_longest(const EditableMesh& mesh, const std::vector<Index>& thin,
                              std::vector<Vec3>& normals) {
  std::vector<char> is_visited(normals.size(), 0);
  std::vector<Index> way;
  for (const Index first : thin) {
    way.clear();
    Index face = first;
    while (face != no_index && normals[face].isZero(0) && is_visited[face] == 0) {
      is_visited[face] = 1;
      way.push_back(face);
      const Index across = mesh.opposite(longest_halfedge(mesh, face));
      face = across == no_index ? no_index : across / 3;
    }
    if (face == no_index) continue;
    for (const Index passed : way) normals[passed] = normals[face];
  }
}

/// Gives each face without a normal the normal of the nearest face that has one. Distance is the
/// number of crossed edges.
void take_over_across_any(const EditableMesh& mesh, std::vector<Vec3>& normals) {
  std::vector<Index> reached;
  for (Index face = 0; face < mesh.face_slots(); ++face)
    if (!normals[face].isZero(0)) reached.push_back(face);
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (Index h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h) {
      const Index across = mesh.opposite(h);
      if (across == no_index || !normals[across / 3].isZero(0)) continue;
      normals[across / 3] = normals[reached[i]];
      reached.push_back(across / 3);
    }
  }
}

/// True if any edge turns by more than 60 degrees, even if only by noise. Most meshes are smooth
/// and need no further test. Needs no square roots.
bool may_have_sharp_edges(const EditableMesh& mesh) {
  std::vector<Vec3> normals(mesh.face_slots());
  std::vector<double> squares(mesh.face_slots());
  for (Index face = 0; face < mesh.face_slots(); ++face) {
    normals[face] = mesh.has_face(face) ? mesh.face_normal(face) : Vec3(Vec3::Zero());
    squares[face] = normals[face].squaredNorm();
  }
  for (Index h = 0; h < mesh.halfedge_slots(); ++h) {
    const Index across = mesh.opposite(h);
    if (across < h || across == no_index) continue;
    const double cosine = normals[h / 3].dot(normals[across / 3]);
    if (!(cosine > 0 && 4 * cosine * cosine > squares[h / 3] * squares[across / 3])) return true;
  }
  return false;
}

/// Total lengths of lines, of sharp edges, and of intended edges. Intended edges are sharp, and
/// sharp edges are lines.
struct SharpLengths {
  double lines = 0, sharp = 0, meant = 0;
};

class SharpEdges {
 public:
  explicit SharpEdges(const EditableMesh& mesh)
      : mesh_(mesh), normals_(steady_normals(mesh)), flattest_(mesh.vertex_slots(), 1) {}

  bool are_meant() {
    for_each_edge([&](Index h, double cosine) { note_smooth(h, cosine); });
    SharpLengths lengths;
    for_each_edge([&](Index h, double cosine) { add(h, cosine, lengths); });
    return lengths.meant > meant_share * lengths.sharp &&
           lengths.meant > meant_of_lines * lengths.lines &&
           lengths.meant > least_length * std::sqrt(area());
  }

 private:
  double area() const {
    double twice = 0;
    for (Index face = 0; face < mesh_.face_slots(); ++face)
      if (mesh_.has_face(face)) twice += mesh_.face_normal(face).norm();
    return twice / 2;
  }
  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    for (Index h = 0; h < mesh_.halfedge_slots(); ++h) {
      if (!mesh_.is_edge(h) || mesh_.is_border(h)) continue;
      const Vec3& here = normals_[h / 3];
      const Vec3& there = normals_[mesh_.opposite(h) / 3];
      if (!here.isZero(0) && !there.isZero(0)) visit(h, here.dot(there));
    }
  }
  // Updates at both ends the cosine of the largest angle of edges that are not lines.
  void note_smooth(Index h, double cosine) {
    if (cosine < line_cosine_) return;
    for (const Index v : {mesh_.source(h), mesh_.target(h)})
      flattest_[v] = std::min(flattest_[v], cosine);
  }
  void add(Index h, double cosine, SharpLengths& lengths) const {
    if (cosine >= line_cosine_) return;
    const double length = std::sqrt(mesh_.squared_length(h));
    lengths.lines += length;
    if (cosine >= sharp_cosine_) return;
    lengths.sharp += length;
    const double beside = std::min(flattest_[mesh_.source(h)], flattest_[mesh_.target(h)]);
    if (angle_of(beside) < smooth_share * angle_of(cosine)) lengths.meant += length;
  }

  const EditableMesh& mesh_;
  std::vector<Vec3> normals_;
  /// For each vertex the least cosine at its edges that are not lines.
  std::vector<double> flattest_;
  double sharp_cosine_ = cosine_of(sharp_deg), line_cosine_ = cosine_of(line_deg);
};

}  // namespace

std::vector<Vec3> steady_normals(const EditableMesh& mesh) {
  std::vector<Vec3> normals(mesh.face_slots(), Vec3::Zero());
  std::vector<Index> thin;
  for (Index face = 0; face < mesh.face_slots(); ++face) {
    if (!mesh.has_face(face)) continue;
    normals[face] = own_normal(mesh, face);
    if (normals[face].isZero(0)) thin.push_back(face);
  }
  if (thin.empty()) return normals;
  take_over_across_longest(mesh, thin, normals);
  take_over_across_any(mesh, normals);
  return normals;
}

bool has_sharp_edges(const EditableMesh& mesh) {
  return may_have_sharp_edges(mesh) && SharpEdges(mesh).are_meant();
}

}  // namespace transformesh
