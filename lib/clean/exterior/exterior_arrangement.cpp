#include "clean/exterior/exterior_arrangement.h"

#include <atomic>
#include <limits>

#include "clean/exterior/exterior_cut.h"
#include "clean/exterior/region_growing_winding.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t planes_per_task = 4;
constexpr int unknown = std::numeric_limits<int>::min();

/// Whether the boundary of the region runs between two sides of a surface.
bool parts(int front, int behind, int winding_level) {
  return (front < winding_level) != (behind < winding_level);
}

/// Chooses the exterior facets of a plane that is cut in full.
class FacetChooser {
 public:
  FacetChooser(const RegionGrowingWinding& windings, const RayCastFrontWinding& ray,
               int winding_level)
      : windings_(windings), ray_(ray), winding_level_(winding_level) {}

  std::vector<char> choose(const PlaneFacets& facets, Index first_face);
  std::size_t rays() const { return rays_; }

 private:
  void spread(const PlaneFacets& facets, Index seed, int w);

  const RegionGrowingWinding& windings_;
  const RayCastFrontWinding& ray_;
  int winding_level_;
  std::vector<int> front_;  ///< per facet
  std::vector<Index> stack_;
  std::size_t rays_ = 0;
};

std::vector<char> FacetChooser::choose(const PlaneFacets& facets, Index first_face) {
  front_.assign(facets.size(), unknown);
  for (Index i = 0; i < 3; ++i) {
    const std::optional<int> w = windings_.at(first_face, i);
    if (w) spread(facets, facets.facet_at_corner(i), *w);
  }
  std::vector<char> chosen(facets.size(), 0);
  for (Index facet = 0; facet < facets.size(); ++facet) {
    if (!facets.is_covered(facet) || facets.multiplicity(facet) == 0) continue;
    if (front_[facet] == unknown) {
      spread(facets, facet, ray_.in_front_of(facets.corners(facet), first_face));
      ++rays_;
    }
    chosen[facet] =
        parts(front_[facet], front_[facet] + facets.multiplicity(facet), winding_level_) ? 1 : 0;
  }
  return chosen;
}

void FacetChooser::spread(const PlaneFacets& facets, Index seed, int w) {
  if (front_[seed] != unknown) return;
  front_[seed] = w;
  stack_.push_back(seed);
  while (!stack_.empty()) {
    const Index facet = stack_.back();
    stack_.pop_back();
    for (Index i = 0; i < 3; ++i) {
      const Index next = facets.neighbor(facet, i);
      if (next == no_index || !facets.is_covered(next) || front_[next] != unknown) continue;
      front_[next] = front_[facet] + facets.jump(facet, i);
      stack_.push_back(next);
    }
  }
}

/// Marks the planes that are to be cut.
std::vector<char> find_visible_planes(const Planes& planes, const RegionGrowingWinding& windings,
                                      int winding_level) {
  std::vector<char> is_visible(planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i)
    is_visible[i] = windings.is_hidden(planes[i], winding_level) ? 0 : 1;
  return is_visible;
}

std::size_t count_without_corner(const Planes& planes, const RegionGrowingWinding& windings,
                                 const std::vector<char>& is_visible) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Index face = planes[i].faces[0];
    const bool has_corner = windings.at(face, 0) || windings.at(face, 1) || windings.at(face, 2);
    count += is_visible[i] && !has_corner ? 1 : 0;
  }
  return count;
}

}  // namespace

ExteriorArrangement arrange_exterior(const std::shared_ptr<const WeldedMesh>& welded,
                                     const std::vector<Meeting>& meetings, int winding_level,
                                     const Progress& progress, const Surroundings* around) {
  progress("arrange");
  if (!meetings.empty()) refuse_overflow(*welded);
  const Planes planes(*welded, meetings);
  const WindingJumps jumps(*welded, planes);
  const RegionGrowingWinding windings(*welded, planes, jumps, around);
  progress("arrange", 0.2);

  const auto is_complete = [&](Index face) { return !around || around->is_complete[face]; };
  std::vector<char> is_visible = find_visible_planes(planes, windings, winding_level);
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (!is_complete(planes[i].faces[0])) is_visible[i] = 0;
  const RayCastFrontWinding ray(*welded, count_without_corner(planes, windings, is_visible),
                                around);
  std::atomic<std::size_t> rays = windings.rays();
  std::vector<PlaneCut> cuts(planes.size());
  parallel_for(cuts.size(), planes_per_task, [&](std::size_t first, std::size_t last) {
    ExteriorCutter cutter(*welded, planes, jumps, windings, ray, winding_level);
    FacetChooser chooser(windings, ray, winding_level);
    for (std::size_t i = first; i < last; ++i) {
      if (!is_visible[i]) continue;
      const Plane plane = planes[i];
      auto cut = cutter.cut(plane);
      cuts[i] =
          cut ? std::move(*cut) : cut_plane(*welded, plane, jumps, [&](const PlaneFacets& facets) {
            return chooser.choose(facets, plane.faces[0]);
          });
    }
    rays += cutter.rays() + chooser.rays();
  });
  progress("arrange", 0.9);

  ExteriorArrangement result;
  std::vector<char> is_left_out(welded->faces.size(), 0);
  for (Index f = 0; f < is_left_out.size(); ++f) {
    if (!planes.is_whole(f)) continue;
    ++result.whole_faces;
    is_left_out[f] = 1;
    if (!is_complete(f)) continue;
    const int w = *windings.at(f, 0);
    is_left_out[f] = parts(w, w + 1, winding_level) ? 0 : 1;
  }
  result.rays = rays;
  result.arrangement = join_cuts(welded, planes, cuts, is_left_out);
  return result;
}

}  // namespace transformesh
