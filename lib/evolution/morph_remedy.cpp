#include "evolution/morph_remedy.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mesh/location_text.h"
#include "step/local_thickness.h"
#include "step/target_query.h"
#include "support/number.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// If the target is farther away from the mesh than this many longest edges, the cause is that
/// source and target are apart. At smaller distances, shorter edges may let the mesh reach the
/// target.
constexpr double few_edges = 3;

/// A gap is resolved by edges that are shorter than the width of the gap divided by this number.
constexpr double edges_across = 2;

/// Number of distances between measured points in a square with the area of the target. It bounds
/// time and memory if edges are tiny, as they are where a small source has vanished: the search for
/// the cause then takes less than a second.
constexpr double most_across = 300;

/// Returns the target with its thickness at points. Neighboring points are at most an edge apart,
/// or on a large target at most a 300th of the side of that square.
Target measured(const Target& target, double edge) {
  const double coarsest = std::sqrt(surface_area(target.mesh)) / most_across;
  const double spacing = std::max(edge, 2 * coarsest);
  return with_thickness(target, edges_across * edge / spacing, spacing);
}

Problem narrow_at(const Vec3& place, double width, double edge, bool has_uniform_edges) {
  return {has_uniform_edges ? ErrorKind::uniform_edges_too_long : ErrorKind::edges_too_long,
          "the target is " + significant(width, 3) + " wide" + at_place(place) +
              ", and edges are up to " + significant(edge, 3) + " long",
          {.position = position_data(place), .lengths = {width, edge}}};
}

/// Returns a problem with the location and width of the thinnest place of the target. Returns
/// nothing if the target is thick enough for edges of length `edge`.
std::optional<Problem> narrowest(const Target& target, double edge, bool has_uniform_edges) {
  const std::vector<double>& widths = target.thickness;
  const auto least = std::min_element(widths.begin(), widths.end());
  if (least == widths.end() || !std::isfinite(*least)) return std::nullopt;
  const auto v = static_cast<std::size_t>(least - widths.begin());
  return narrow_at(target.mesh.positions[v], *least, edge, has_uniform_edges);
}

bool is_far(const Mismatch& found) { return found.distance > few_edges * found.longest_edge; }

// Returns a problem with a narrow place of the target, if there is one. If the topology of mesh and
// target differs, returns the narrowest place: the cause may be far from the place where mesh and
// target are farthest apart. A part of the target that is far from the mesh was not reached,
// however narrow other parts are.
std::optional<Problem> narrow_place(const TargetQuery& target, const Mismatch& found) {
  const double edge = found.longest_edge;
  if (found.is_of_topology && !(found.is_on_target && is_far(found)))
    return narrowest(measured(target.target(), edge), edge, found.has_uniform_edges);
  const double width = local_thickness_near(target, found.place, edges_across * edge);
  if (!std::isfinite(width)) return std::nullopt;
  return narrow_at(found.place, width, edge, found.has_uniform_edges);
}

}  // namespace

Problem cause_of(const TargetQuery& target, const Mismatch& found) {
  const double edge = found.longest_edge;
  if (!found.has_clean_target) return {ErrorKind::target_not_solid, "", {.lengths = {edge}}};
  if (const auto narrow = narrow_place(target, found)) return *narrow;
  return {
      is_far(found) ? ErrorKind::source_apart : ErrorKind::edges_too_long, "", {.lengths = {edge}}};
}

Problem cause_of_vanishing(const Target& target, double longest_edge, bool has_uniform_edges) {
  const Target all = measured(target, longest_edge);
  const auto narrow = std::count_if(all.thickness.begin(), all.thickness.end(),
                                    [](double width) { return std::isfinite(width); });
  if (2 * static_cast<std::size_t>(narrow) < all.thickness.size())
    return {ErrorKind::source_apart, "", {.lengths = {longest_edge}}};
  return narrowest(all, longest_edge, has_uniform_edges)
      .value_or(Problem{ErrorKind::surface_vanished});
}

std::string at_place(const Vec3& place) {
  std::string text = " at (" + significant(place.x(), 4) + ", " + significant(place.y(), 4);
  return text.append(", ").append(significant(place.z(), 4)).append(")");
}

}  // namespace transformesh
