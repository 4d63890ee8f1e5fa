#include "evolution/morph_remedy.h"

#include <algorithm>
#include <cmath>

#include "step/local_thickness.h"
#include "step/target_query.h"
#include "support/number.h"

namespace transformesh {
namespace {

constexpr double few_edges = 3;
/// A gap is resolved by edges shorter than half of it.
constexpr double edges_across = 2;

Target measured(const Target& target, double edge) {
  return with_thickness(target, edges_across, edge);
}

/// The narrowest vertex of the target.
MorphRemedy narrowest(const Target& target, const std::vector<double>& widths, double edge) {
  const auto least = std::min_element(widths.begin(), widths.end());
  if (least == widths.end() || !std::isfinite(*least)) return {};
  const auto v = static_cast<std::size_t>(least - widths.begin());
  return {RemedyKind::edges_at_narrow_places, edge, *least, target.mesh.positions[v]};
}

// Names the narrowest place if the topology differs: the cause may be far from the place where mesh
// and target are farthest apart.
MorphRemedy narrow_place(const TargetQuery& target, const Mismatch& found) {
  const double edge = found.longest_edge;
  if (found.is_of_topology) {
    const Target all = measured(target.target(), edge);
    return narrowest(all, all.thickness, edge);
  }
  const double width = local_thickness_near(target, found.place, edges_across * edge);
  if (!std::isfinite(width)) return {};
  return {RemedyKind::edges_at_narrow_places, edge, width, found.place};
}

}  // namespace

MorphRemedy remedy_for(const TargetQuery& target, const Mismatch& found) {
  const double edge = found.longest_edge;
  if (!found.has_clean_target) return {RemedyKind::clean_target, edge};
  MorphRemedy narrow = narrow_place(target, found);
  if (narrow.kind != RemedyKind::none) return narrow;
  if (found.distance > few_edges * edge) return {RemedyKind::larger_source, edge};
  return {RemedyKind::shorter_edges, edge};
}

MorphRemedy remedy_for_vanished(const Target& target, double longest_edge) {
  const Target all = measured(target, longest_edge);
  const auto narrow = std::count_if(all.thickness.begin(), all.thickness.end(),
                                    [](double width) { return std::isfinite(width); });
  if (2 * static_cast<std::size_t>(narrow) < all.thickness.size())
    return {RemedyKind::larger_source, longest_edge};
  return narrowest(all, all.thickness, longest_edge);
}

std::string at_place(const Vec3& place) {
  std::string text = " at (" + significant(place.x(), 4) + ", " + significant(place.y(), 4);
  return text.append(", ").append(significant(place.z(), 4)).append(")");
}

std::string reason_of(const MorphRemedy& remedy) {
  if (remedy.kind != RemedyKind::edges_at_narrow_places) return {};
  return "the target is " + significant(remedy.width, 3) + " wide" + at_place(remedy.place) +
         ", and edges are up to " + significant(remedy.edge, 3) + " long";
}

}  // namespace transformesh
