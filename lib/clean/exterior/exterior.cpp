#include "clean/exterior/exterior.h"

#include <algorithm>
#include <limits>
#include <string>

#include "clean/exterior/patches.h"
#include "clean/exterior/ray_cast_front_winding.h"
#include "mesh/components.h"
#include "support/empty_result_error.h"
#include "support/error.h"

namespace transformesh {
namespace {

constexpr int unknown = std::numeric_limits<int>::min();
constexpr std::size_t tries_per_patch = 8;
constexpr std::size_t tries_per_seed = 64;

bool is_kept(int front, const Piece& piece, int winding_level) {
  return front < winding_level && front + piece.multiplicity >= winding_level;
}

/// Region growing (paper 3.2): finds the winding number in front of every patch, from seeds on.
class Growth {
 public:
  Growth(const Arrangement& arrangement, int winding_level, const BorderClosure& closure);
  Exterior grow(const Progress& progress);

 private:
  bool keeps(Index patch) const;
  void cast_ray(Index patch, std::size_t member);
  std::vector<Index> connected_patches(Index first) const;
  Index find_open_seed(Index first);
  void spread(Index seed);

  const Arrangement& arrangement_;
  int winding_level_;
  bool is_open_;
  Patches patches_;
  RayCastFrontWinding ray_;
  std::vector<int> front_;  ///< per patch: w in front of it, or unknown
  std::size_t rays_ = 0;
};

Growth::Growth(const Arrangement& arrangement, int winding_level, const BorderClosure& closure)
    : arrangement_(arrangement),
      winding_level_(winding_level),
      is_open_(!closure.empty()),
      patches_(arrangement),
      ray_(arrangement, closure, (is_open_ ? tries_per_seed : 1) * patches_.size()),
      front_(patches_.size(), unknown) {}

bool Growth::keeps(Index patch) const {
  return is_kept(front_[patch], arrangement_.pieces[patches_.pieces[patch].front()],
                 winding_level_);
}

void Growth::cast_ray(Index patch, std::size_t member) {
  front_[patch] = ray_.in_front_of(arrangement_.pieces[patches_.pieces[patch][member]]);
  ++rays_;
}

// The patches that are connected with the first, the largest ones first: these are the likeliest to
// be exterior.
std::vector<Index> Growth::connected_patches(Index first) const {
  std::vector<Index> connected{first};
  std::vector<char> seen(patches_.size(), 0);
  seen[first] = 1;
  for (std::size_t i = 0; i < connected.size(); ++i) {
    for (const Patches::Relation& relation : patches_.relations[connected[i]]) {
      if (seen[relation.patch]) continue;
      seen[relation.patch] = 1;
      connected.push_back(relation.patch);
    }
  }
  std::stable_sort(connected.begin(), connected.end(), [&](Index a, Index b) {
    return patches_.pieces[a].size() > patches_.pieces[b].size();
  });
  return connected;
}

// A patch with a piece that is exterior, which makes it a seed. Several pieces of it are tried, as
// closing borders makes w vary in front of a patch. Where none is found, it is the largest patch.
Index Growth::find_open_seed(Index first) {
  const std::vector<Index> connected = connected_patches(first);
  std::size_t tries = 0;
  for (const Index patch : connected) {
    const std::size_t size = patches_.pieces[patch].size();
    const std::size_t count = std::min(size, tries_per_patch);
    for (std::size_t i = 0; i < count; ++i) {
      cast_ray(patch, i * size / count);
      if (keeps(patch)) return patch;
    }
    front_[patch] = unknown;
    tries += count;
    if (tries >= tries_per_seed) break;
  }
  cast_ray(connected.front(), 0);
  return connected.front();
}

// Carries w from the seed over all patches that are connected with it. In an open mesh a patch that
// is kept is surer than others, so it goes first.
void Growth::spread(Index seed) {
  std::vector<Index> kept;
  std::vector<Index> others;
  const auto put = [&](Index patch) { (keeps(patch) ? kept : others).push_back(patch); };
  put(seed);
  while (!kept.empty() || !others.empty()) {
    std::vector<Index>& stack = kept.empty() ? others : kept;
    const Index patch = stack.back();
    stack.pop_back();
    for (const Patches::Relation& relation : patches_.relations[patch]) {
      if (front_[relation.patch] != unknown) continue;
      front_[relation.patch] = front_[patch] + relation.offset;
      put(relation.patch);
    }
  }
}

Exterior Growth::grow(const Progress& progress) {
  progress("exterior", 0.5);
  for (Index first = 0; first < patches_.size(); ++first) {
    if (front_[first] != unknown) continue;
    Index seed = first;
    if (is_open_) {
      seed = find_open_seed(first);
    } else {
      cast_ray(seed, 0);
    }
    spread(seed);
  }

  Exterior result;
  result.patches = patches_.size();
  result.rays = rays_;
  result.kept.assign(arrangement_.pieces.size(), 0);
  for (std::size_t p = 0; p < result.kept.size(); ++p) {
    const Index patch = patches_.patch_of[p];
    if (patch == no_index) continue;
    result.kept[p] = is_kept(front_[patch], arrangement_.pieces[p], winding_level_) ? 1 : 0;
  }
  return result;
}

Exterior test_all(const Arrangement& arrangement, int winding_level, const Progress& progress) {
  const RayCastFrontWinding ray(arrangement, BorderClosure(), arrangement.pieces.size());
  progress("exterior", 0.1);
  Exterior result;
  result.kept.assign(arrangement.pieces.size(), 0);
  result.rays = arrangement.pieces.size();
  for (std::size_t p = 0; p < result.kept.size(); ++p) {
    const Piece& piece = arrangement.pieces[p];
    const bool kept =
        piece.multiplicity != 0 && is_kept(ray.in_front_of(piece), piece, winding_level);
    result.kept[p] = kept ? 1 : 0;
  }
  return result;
}

std::string nothing_kept(const Arrangement& arrangement, int winding_level, bool is_open) {
  if (winding_level != 1) {
    return "no winding number reaches " + std::to_string(winding_level) +
           ": nothing lies inside that many sheets";
  }
  if (is_open) {
    return "every face of this open mesh lies inside once its borders are closed: it is inside "
           "out; reverse it with tm-stitch --flip";
  }
  const auto counts = [](const Piece& piece) { return piece.multiplicity != 0; };
  if (std::none_of(arrangement.pieces.begin(), arrangement.pieces.end(), counts)) {
    const std::string why =
        arrangement.pieces.empty()
            ? "they have no area"
            : "they lie upon each other and cancel out, as in a difference without a remainder, or "
              "a sheet whose border is filled flat; tm-sample and tm-wrap --method alpha go around "
              "a sheet";
    return "the faces enclose nothing: " + why +
           "; a shape that is small or far from the origin needs --double, or to be moved there";
  }
  return "no point has a winding number >= 1: a difference without a remainder is empty; a mesh "
         "that is inside out is reversed by tm-stitch --flip";
}

// Whether each component of a mesh lies within others: whether w > 0 in front of its first face.
std::vector<char> find_enclosed(const Mesh& mesh, const Components& components) {
  const auto welded = std::make_shared<const WeldedMesh>(weld(mesh));
  const Arrangement arrangement = arrange(welded, {}, Progress());
  const RayCastFrontWinding ray(arrangement, BorderClosure(), components.components.size());
  std::vector<char> enclosed(components.components.size(), 0);
  std::vector<char> seen(components.components.size(), 0);
  for (std::size_t p = 0; p < arrangement.pieces.size(); ++p) {
    const Index component = components.of_face[welded->face_of[p]];
    if (seen[component]) continue;
    seen[component] = 1;
    enclosed[component] = ray.in_front_of(arrangement.pieces[p]) > 0;
  }
  return enclosed;
}

std::size_t drop_components(Mesh& mesh, const Components& components,
                            const std::vector<char>& dropped) {
  const auto count = static_cast<std::size_t>(std::count(dropped.begin(), dropped.end(), 1));
  if (count == 0) return 0;
  std::vector<bool> keep(mesh.faces.size());
  for (std::size_t f = 0; f < keep.size(); ++f) keep[f] = !dropped[components.of_face[f]];
  mesh = select_faces(mesh, keep);
  return count;
}

}  // namespace

Exterior find_exterior(const Arrangement& arrangement, int winding_level, ExteriorMethod method,
                       const BorderClosure& closure, const Progress& progress) {
  progress("exterior");
  Exterior result = method == ExteriorMethod::grow
                        ? Growth(arrangement, winding_level, closure).grow(progress)
                        : test_all(arrangement, winding_level, progress);
  if (std::find(result.kept.begin(), result.kept.end(), 1) == result.kept.end()) {
    throw EmptyResultError(nothing_kept(arrangement, winding_level, !closure.empty()));
  }
  return result;
}

std::size_t drop_enclosed_components(Mesh& mesh) {
  return drop_enclosed_components(mesh, connected_components(mesh));
}

// Nothing lies inside a clean mesh but cavities and what floats in them.
std::size_t drop_enclosed_components(Mesh& mesh, const Components& components) {
  std::vector<char> is_cavity;
  for (const Component& c : components.components) {
    is_cavity.push_back(c.boundary_loops == 0 && c.volume < 0);
  }
  const std::size_t cavities = drop_components(mesh, components, is_cavity);
  if (cavities == 0) return 0;
  const Components solids = connected_components(mesh);
  return cavities + drop_components(mesh, solids, find_enclosed(mesh, solids));
}

}  // namespace transformesh
