#include "clean/exterior/exterior_arrangement.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include "clean/exterior/exterior_cut.h"
#include "clean/exterior/region_growing_winding.h"
#include "support/numbered_selection.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t planes_per_cutting_task = 4;  ///< planes cut in one task; affects time only
constexpr int unknown_winding = std::numeric_limits<int>::min();

/// True if exactly one of the winding numbers in front and behind is below the winding level.
bool parts(int front, int behind, int winding_level) {
  return (front < winding_level) != (behind < winding_level);
}

/// Chooses the exterior facets (triangles) of a plane whose faces are cut along all intersections.
class FacetChooser {
 public:
  FacetChooser(const RegionGrowingWinding& windings, const RayCastFrontWinding& ray,
               int winding_level)
      : windings_(windings), ray_(ray), winding_level_(winding_level) {}

  std::vector<char> choose(const PlaneFacets& facets, Index first_face);
  /// Returns for each of the given facets whether it is an open piece, and its winding number in
  /// front. The facets must be in the plane that was processed last.
  std::vector<OpenFacet> describe(const std::vector<Index>& facets) const;
  bool is_chosen(Index facet) const { return is_chosen_[facet] != 0; }
  /// True if any facet of any plane has a surface: its coincident faces do not cancel out.
  bool has_surface() const { return has_surface_; }
  std::size_t rays() const { return rays_; }

 private:
  void choose_facet(const PlaneFacets& facets, Index facet);
  void spread(const PlaneFacets& facets, Index seed, int w);

  const RegionGrowingWinding& windings_;
  const RayCastFrontWinding& ray_;
  int winding_level_;
  std::vector<int> front_;       ///< winding number in front of each facet
  std::vector<char> is_chosen_;  ///< 1 for each chosen facet
  /// For each facet whether it is open, and its winding number in front.
  std::vector<OpenFacet> open_;
  std::vector<Index> stack_;
  std::size_t rays_ = 0;
  bool has_surface_ = false;
};

std::vector<char> FacetChooser::choose(const PlaneFacets& facets, Index first_face) {
  front_.assign(facets.size(), unknown_winding);
  is_chosen_.assign(facets.size(), 0);
  open_.assign(facets.size(), {false, 0});
  for (Index i = 0; i < 3; ++i) {
    const std::optional<int> w = windings_.at(first_face, i);
    if (w) spread(facets, facets.facet_at_corner(i), *w);
  }
  for (Index facet = 0; facet < facets.size(); ++facet) {
    if (!facets.is_covered(facet)) continue;
    if (facets.multiplicity(facet) == 0 && !facets.has_open_face(facet)) continue;
    has_surface_ = true;
    if (front_[facet] == unknown_winding) {
      spread(facets, facet, ray_.in_front_of(facets.corners(facet), first_face));
      ++rays_;
    }
    choose_facet(facets, facet);
  }
  return is_chosen_;
}

void FacetChooser::choose_facet(const PlaneFacets& facets, Index facet) {
  const int front = front_[facet], behind = front + facets.multiplicity(facet);
  const bool is_boundary = parts(front, behind, winding_level_);
  const bool is_open = !is_boundary && facets.has_open_face(facet);
  is_chosen_[facet] = is_boundary || is_open ? 1 : 0;
  open_[facet] = {is_open, is_open ? std::max(front, behind) : std::min(front, behind)};
}

std::vector<OpenFacet> FacetChooser::describe(const std::vector<Index>& facets) const {
  std::vector<OpenFacet> result;
  result.reserve(facets.size());
  for (const Index facet : facets) result.push_back(open_[facet]);
  return result;
}

void FacetChooser::spread(const PlaneFacets& facets, Index seed, int w) {
  if (front_[seed] != unknown_winding) return;
  front_[seed] = w;
  stack_.push_back(seed);
  while (!stack_.empty()) {
    const Index facet = stack_.back();
    stack_.pop_back();
    for (Index i = 0; i < 3; ++i) {
      const Index next = facets.neighbor(facet, i);
      if (next == no_index || !facets.is_covered(next) || front_[next] != unknown_winding) continue;
      front_[next] = front_[facet] + facets.jump(facet, i);
      stack_.push_back(next);
    }
  }
}

class ExteriorArranger {
 public:
  ExteriorArranger(const std::shared_ptr<const WeldedMesh>& welded,
                   const std::vector<Meeting>& meetings, const ExteriorArrangementOptions& options)
      : welded_(welded),
        options_(options),
        planes_(*welded, meetings),
        jumps_(*welded, planes_),
        windings_(*welded, planes_, jumps_, options.around),
        is_visible_(find_visible_planes()),
        ray_(*welded, count_without_corner(), options.around),
        rays_(windings_.rays()),
        cuts_(planes_.size()),
        chosen_(options.arranges_everything ? planes_.size() : 0) {}
  ExteriorArrangement arrange(const Progress& progress);

 private:
  std::vector<char> find_visible_planes() const;
  std::size_t count_without_corner() const;
  bool has_hidden_planes() const;
  bool is_complete(Index face) const {
    return options_.around == nullptr || options_.around->is_complete[face];
  }
  void cut_planes(std::size_t first, std::size_t last);
  void cut_in_full(std::size_t i, FacetChooser& chooser);
  bool arranges_whole(Index face) const;
  void describe_whole_pieces(Arrangement& arrangement) const;
  std::vector<char> find_kept(const Arrangement& arrangement) const;

  std::shared_ptr<const WeldedMesh> welded_;
  const ExteriorArrangementOptions& options_;
  Planes planes_;
  WindingJumps jumps_;
  RegionGrowingWinding windings_;
  /// 1 for each plane (face, or coplanar faces that meet) that is cut.
  std::vector<char> is_visible_;
  RayCastFrontWinding ray_;
  std::atomic<std::size_t> rays_;
  std::atomic<bool> has_surface_ = false;
  std::vector<PlaneCut> cuts_;  ///< the pieces of each plane
  /// For each plane a list with 1 for each chosen facet of its cut. Empty if `arranges_everything`
  /// is not set.
  std::vector<std::vector<char>> chosen_;
};

std::vector<char> ExteriorArranger::find_visible_planes() const {
  std::vector<char> is_visible(planes_.size());
  parallel_for_each(planes_.size(), [&](std::size_t i) {
    const bool is_hidden =
        !options_.arranges_everything && windings_.is_hidden(planes_[i], options_.winding_level);
    is_visible[i] = is_complete(planes_[i].faces[0]) && !is_hidden ? 1 : 0;
  });
  return is_visible;
}

// True if a plane is not cut, because it is hidden or because its surroundings are missing. A
// hidden plane contains a single face that does not cancel out; hence the mesh has a surface.
bool ExteriorArranger::has_hidden_planes() const {
  return std::find(is_visible_.begin(), is_visible_.end(), 0) != is_visible_.end();
}

std::size_t ExteriorArranger::count_without_corner() const {
  const auto has_none = [&](std::size_t i) {
    const Index f = planes_[i].faces[0];
    return is_visible_[i] && !windings_.at(f, 0) && !windings_.at(f, 1) && !windings_.at(f, 2);
  };
  return NumberedSelection(planes_.size(), has_none).size();
}

void ExteriorArranger::cut_planes(std::size_t first, std::size_t last) {
  ExteriorCutter cutter(*welded_, planes_, jumps_, windings_, ray_, options_.winding_level);
  FacetChooser chooser(windings_, ray_, options_.winding_level);
  bool has_surface = false;
  for (std::size_t i = first; i < last; ++i) {
    if (!is_visible_[i]) continue;
    auto cut = options_.arranges_everything ? std::nullopt : cutter.cut(planes_[i]);
    if (cut) {
      has_surface = true;
      cuts_[i] = std::move(*cut);
    } else {
      cut_in_full(i, chooser);
    }
  }
  rays_ += cutter.rays() + chooser.rays();
  if (has_surface || chooser.has_surface()) has_surface_ = true;
}

void ExteriorArranger::cut_in_full(std::size_t i, FacetChooser& chooser) {
  const Plane plane = planes_[i];
  cuts_[i] = cut_plane(*welded_, plane, jumps_, [&](const PlaneFacets& facets) {
    std::vector<char> chosen = chooser.choose(facets, plane.faces[0]);
    for (Index f = 0; options_.arranges_everything && f < facets.size(); ++f)
      chosen[f] = facets.is_covered(f) ? 1 : 0;
    return chosen;
  });
  if (!welded_->open_component.empty()) cuts_[i].open = chooser.describe(cuts_[i].numbers);
  for (const Index facet : cuts_[i].numbers)
    if (options_.arranges_everything) chosen_[i].push_back(chooser.is_chosen(facet) ? 1 : 0);
}

bool ExteriorArranger::arranges_whole(Index face) const {
  if (!is_complete(face)) return false;
  const int w = *windings_.at(face, 0);
  return options_.arranges_everything || welded_->is_open(face) ||
         parts(w, w + 1, options_.winding_level);
}

void ExteriorArranger::describe_whole_pieces(Arrangement& arrangement) const {
  parallel_for_each(arrangement.whole_pieces, [&](std::size_t p) {
    Piece& piece = arrangement.pieces[p];
    const Index face = arrangement.sources_of(piece).front().face;
    piece.is_open = welded_->is_open(face);
    piece.front = *windings_.at(face, 0);
  });
}

std::vector<char> ExteriorArranger::find_kept(const Arrangement& arrangement) const {
  const auto is_kept = [&](const Piece& piece) {
    return piece.is_open ? piece.front < options_.winding_level
                         : parts(piece.front, piece.front + 1, options_.winding_level);
  };
  std::vector<char> kept(arrangement.pieces.size(), 1);
  parallel_for_each(kept.size(), [&](std::size_t p) {
    if (p < arrangement.whole_pieces || arrangement.pieces[p].is_open)
      kept[p] = is_kept(arrangement.pieces[p]) ? 1 : 0;
  });
  std::size_t p = arrangement.whole_pieces;
  for (const std::vector<char>& of_plane : chosen_)
    for (const char is_chosen : of_plane) kept[p++] = is_chosen;
  return kept;
}

ExteriorArrangement ExteriorArranger::arrange(const Progress& progress) {
  progress("arrange", 0.2);
  parallel_for(cuts_.size(), planes_per_cutting_task,
               [&](std::size_t first, std::size_t last) { cut_planes(first, last); });
  progress("arrange", 0.9);

  ExteriorArrangement result;
  std::vector<char> is_left_out(welded_->faces.size());
  parallel_for_each(is_left_out.size(), [&](Index f) {
    is_left_out[f] = planes_.is_whole(f) && !arranges_whole(f) ? 1 : 0;
  });
  result.whole_faces = planes_.whole_faces();
  result.rays = rays_;
  result.has_surface = result.whole_faces > 0 || has_hidden_planes() || has_surface_;
  result.arrangement = join_cuts(welded_, planes_, cuts_, is_left_out);
  describe_whole_pieces(result.arrangement);
  result.kept = find_kept(result.arrangement);
  return result;
}

}  // namespace

ExteriorArrangement arrange_exterior(const std::shared_ptr<const WeldedMesh>& welded,
                                     const std::vector<Meeting>& meetings,
                                     const ExteriorArrangementOptions& options,
                                     const Progress& progress) {
  progress("arrange");
  if (!meetings.empty()) refuse_overflow(*welded);
  return ExteriorArranger(welded, meetings, options).arrange(progress);
}

}  // namespace transformesh
