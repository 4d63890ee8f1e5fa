#include "clean/rounding/slivers.h"

#include <map>
#include <optional>
#include <utility>

#include "clean/rounding/broken_faces.h"
#include "clean/rounding/triangle_distance.h"

namespace transformesh {
namespace {

/// Largest number of flips of a face in one round of repair (snap_rounding.h). With 1, repair fails
/// in 5 of 220 difficult test meshes. With 6, repair fails for nearly coplanar faces
/// (docs/design/rounding.md).
constexpr int most_flips_of_face = 3;

class SliverFlipper {
 public:
  SliverFlipper(Assembly& assembly, const std::vector<Index>& faces, double steps,
                const VertexGrids& grids);
  bool flip_all(Displacement& moved);

 private:
  /// The longest edge a-b of a face, its opposite corner (the apex), and the height of the apex.
  struct Sliver {
    Index a, b, apex;
    double height;
  };

  double reach(Index vertex) const { return steps_ * grids_.step(mesh_, vertex); }
  std::optional<Sliver> sliver_of(const Face& face) const;
  void try_flip(Index face);
  void flip(Index face, Index across, const Sliver& sliver);
  void link(Index face);
  void unlink(Index face);

  Assembly& assembly_;
  Mesh& mesh_;
  double steps_;
  const VertexGrids& grids_;
  std::vector<Index> stack_;
  /// Maps the two ends of each halfedge to its face, for the faces to flip and their neighbors.
  std::map<std::pair<Index, Index>, Index> face_at_;
  std::map<Index, int> flips_;  ///< number of flips attempted for each face
  /// Displacement of each face by all flips that changed it.
  std::map<Index, Displacement> moved_;
};

SliverFlipper::SliverFlipper(Assembly& assembly, const std::vector<Index>& faces, double steps,
                             const VertexGrids& grids)
    : assembly_(assembly),
      mesh_(assembly.mesh),
      steps_(steps),
      grids_(grids),
      stack_(faces.rbegin(), faces.rend()) {
  for (const Index face : with_faces_around(mesh_, faces)) link(face);
}

void SliverFlipper::link(Index face) {
  const Face& f = mesh_.faces[face];
  for (std::size_t i = 0; i < 3; ++i) face_at_[{f[i], f[(i + 1) % 3]}] = face;
}

void SliverFlipper::unlink(Index face) {
  const Face& f = mesh_.faces[face];
  for (std::size_t i = 0; i < 3; ++i) {
    const auto found = face_at_.find({f[i], f[(i + 1) % 3]});
    if (found != face_at_.end() && found->second == face) face_at_.erase(found);
  }
}

std::optional<SliverFlipper::Sliver> SliverFlipper::sliver_of(const Face& face) const {
  std::optional<Sliver> sliver;
  double longest = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Index a = face[i], b = face[(i + 1) % 3], apex = face[(i + 2) % 3];
    const Vec3 &p = mesh_.positions[a], &q = mesh_.positions[b];
    const double length = (q - p).stableNorm();
    if (length <= longest) continue;
    const LineDistance from_edge = distance_from_line(p, q, mesh_.positions[apex]);
    if (from_edge.beyond > reach(apex)) continue;
    longest = length;
    sliver = {a, b, apex, from_edge.distance};
  }
  return sliver;
}

void SliverFlipper::try_flip(Index face) {
  if (is_collapsed(mesh_.faces[face]) || ++flips_[face] > most_flips_of_face) return;
  const std::optional<Sliver> sliver = sliver_of(mesh_.faces[face]);
  if (!sliver || !(sliver->height <= reach(sliver->apex))) return;
  const auto across = face_at_.find({sliver->b, sliver->a});
  if (across == face_at_.end() || across->second == face) return;
  flip(face, across->second, *sliver);
}

// The faces (a, b, apex) and (b, a, opposite) become (a, opposite, apex) and (opposite, b, apex).
void SliverFlipper::flip(Index face, Index across, const Sliver& sliver) {
  Index opposite = sliver.a;
  for (const Index v : mesh_.faces[across])
    if (v != sliver.a && v != sliver.b) opposite = v;
  const double spacing = spacing_around(mesh_.positions[sliver.apex], grids_.type());
  moved_[face].note(moved_[across]);
  moved_[face] += {sliver.height / spacing, sliver.height};
  moved_[across] = moved_[face];
  unlink(face);
  unlink(across);
  assembly_.source_face[face] = assembly_.source_face[across];
  assembly_.face_is_new[face] = assembly_.face_is_new[across] = 1;
  mesh_.faces[face] = {sliver.a, opposite, sliver.apex};
  mesh_.faces[across] = {opposite, sliver.b, sliver.apex};
  for (const Index f : {across, face}) {
    if (is_collapsed(mesh_.faces[f])) continue;
    link(f);
    stack_.push_back(f);
  }
}

bool SliverFlipper::flip_all(Displacement& moved) {
  while (!stack_.empty()) {
    const Index face = stack_.back();
    stack_.pop_back();
    try_flip(face);
  }
  Displacement most;
  for (const auto& [face, total] : moved_) most.note(total);
  moved += most;
  return !moved_.empty();
}

}  // namespace

bool flip_slivers(Assembly& assembly, const std::vector<Index>& faces, double steps,
                  const VertexGrids& grids, Displacement& moved) {
  return SliverFlipper(assembly, faces, steps, grids).flip_all(moved);
}

}  // namespace transformesh
