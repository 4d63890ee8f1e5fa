#include "remesh/operations/exact_split.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace transformesh {
namespace {

/// Positions along the edge that are tried for the new vertex, as shares of the edge.
constexpr std::array<double, 5> shares{0.5, 0.4375, 0.5625, 0.375, 0.625};

Vec3 point_on(const Vec3& a, const Vec3& b, double share) { return (1 - share) * a + share * b; }

/// Returns the next number above (step 1) or below (step -1) a coordinate in the type of
/// coordinates.
double neighbor_of(double x, int step, bool is_single) {
  if (step == 0) return x;
  if (is_single) return std::nextafter(static_cast<float>(x), step > 0 ? HUGE_VALF : -HUGE_VALF);
  return std::nextafter(x, step > 0 ? HUGE_VAL : -HUGE_VAL);
}

}  // namespace

std::vector<Index> ExactSplitter::split(Index halfedge, bool keep_border) {
  find_copies(halfedge);
  const auto is_kept = [&](Index copy) { return keep_border && mesh_.is_border(copy); };
  if (std::any_of(copies_.begin(), copies_.end(), is_kept)) return {};
  gather_replaced();
  const Vec3 source = mesh_.position(mesh_.source(halfedge));
  const Vec3 target = mesh_.position(mesh_.target(halfedge));

  std::vector<Vec3> positions;
  positions.reserve(shares.size() + 27);
  for (const double share : shares)
    positions.push_back(mesh_.rounded(point_on(source, target, share)));
  const Vec3 middle = positions[0];
  const bool is_single = mesh_.coordinate() == Scalar::float32;
  for (int i = 0; i < 27; ++i) {
    const std::array<int, 3> steps{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
    Vec3 beside;
    for (int k = 0; k < 3; ++k) beside[k] = neighbor_of(middle[k], steps[k], is_single);
    positions.push_back(beside);
  }
  const auto found = std::find_if(positions.begin(), positions.end(),
                                  [&](const Vec3& position) { return try_position(position); });
  if (found == positions.end()) return {};
  std::vector<Index> vertices;
  for (const Index copy : copies_) vertices.push_back(split_at(copy, *found));
  return vertices;
}

/// Fills copies_ with the edge and all edges whose ends have the same positions.
void ExactSplitter::find_copies(Index halfedge) {
  const Vec3& a = mesh_.position(mesh_.source(halfedge));
  const Vec3& b = mesh_.position(mesh_.target(halfedge));
  copies_.assign(1, halfedge);
  guard_.for_each_near({a, a, b}, [&](Index face) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      const Vec3& from = mesh_.position(mesh_.source(h));
      const Vec3& to = mesh_.position(mesh_.target(h));
      const bool is_copy = (from == a && to == b) || (from == b && to == a);
      if (!is_copy || h == halfedge || h == mesh_.opposite(halfedge)) continue;
      copies_.push_back(mesh_.is_border(h) ? h : std::min(h, mesh_.opposite(h)));
    }
    return true;
  });
  std::sort(copies_.begin(), copies_.end());
  copies_.erase(std::unique(copies_.begin(), copies_.end()), copies_.end());
}

void ExactSplitter::gather_replaced() {
  replaced_.clear();
  for (const Index copy : copies_) {
    replaced_.push_back(copy / 3);
    if (!mesh_.is_border(copy)) replaced_.push_back(mesh_.opposite(copy) / 3);
  }
}

/// True if a vertex already exists at the position; the new vertex would touch it.
bool ExactSplitter::is_taken(const Vec3& position) const {
  return !guard_.for_each_near({position, position, position}, [&](Index face) {
    const Triangle triangle = mesh_.triangle(face);
    return std::find(triangle.begin(), triangle.end(), position) == triangle.end();
  });
}

bool ExactSplitter::try_position(const Vec3& position) {
  if (is_taken(position)) return false;
  made_.clear();
  for (const Index copy : copies_) {
    for (const Index h : {copy, mesh_.opposite(copy)}) {
      if (h == no_index) continue;
      const Vec3& apex = mesh_.position(mesh_.apex(h));
      made_.push_back({mesh_.position(mesh_.source(h)), position, apex});
      made_.push_back({position, mesh_.position(mesh_.target(h)), apex});
    }
  }
  return guard_.allows(made_, replaced_);
}

Index ExactSplitter::split_at(Index halfedge, const Vec3& position) {
  const Index face = halfedge / 3;
  const Index across = mesh_.opposite(halfedge);
  const Index half = mesh_.face_slots();
  const Index vertex = mesh_.split(halfedge, position);
  guard_.divide(face, std::array{face, half});
  if (across != no_index) guard_.divide(across / 3, std::array{across / 3, half + 1});
  return vertex;
}

}  // namespace transformesh
