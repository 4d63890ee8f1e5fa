#include "remesh/guards/projected_faces.h"

#include <algorithm>
#include <utility>

namespace transformesh {
namespace {

/// Faces are projected onto a triangle only if its squared ratio of height to longest edge is above
/// this. In narrower triangles, barycentric coordinates have rounding errors above 1e-10.
constexpr double least_squared_sine = 1e-12;
/// An edge may meet the triangle if its distance from the triangle is below this share of the
/// triangle's size. Rounding errors of the barycentric coordinates are a tenth of this share. A
/// larger margin only collects more faces.
constexpr double share_margin = 1e-9;

bool is_wide(const TriangleAxes& axes) {
  const double longest = std::max({axes.first.squaredNorm(), axes.second.squaredNorm(),
                                   (axes.second - axes.first).squaredNorm()});
  return axes.squared_normal > least_squared_sine * longest * longest;
}

}  // namespace

ProjectedFaces::ProjectedFaces(const Mesh& mesh, std::vector<Index> opposites,
                               bool stops_at_corners)
    : mesh_(mesh),
      opposites_(std::move(opposites)),
      stops_at_corners_(stops_at_corners),
      stamps_(mesh.faces.size(), 0) {}

/// True if the projected edge may meet the triangle. Tests whether one of the triangle's edges or
/// the edge itself is a separating line.
bool ProjectedFaces::may_meet(const Place& from, const Place& to) {
  if (std::max(from.first, to.first) < -share_margin ||
      std::max(from.second, to.second) < -share_margin ||
      std::max(from.rest(), to.rest()) < -share_margin)
    return false;
  const double x = to.first - from.first, y = to.second - from.second;
  const double origin = y * from.first - x * from.second;
  const double least =
      share_margin * (1 + x * x + y * y + from.first * from.first + from.second * from.second);
  const auto [low, high] = std::minmax({origin, origin - y, origin + x});
  return !(low > least || high < -least);
}

/// Returns the signed number of times that the edge crosses the ray from the triangle's center
/// along the first axis: 1 upwards, -1 downwards. The ends are sorted, so both halfedges of an edge
/// yield opposite numbers.
int ProjectedFaces::turns_around_middle(const Place& from, const Place& to) {
  constexpr double middle = 1.0 / 3;  // barycentric coordinate of the center
  const bool is_above = from.second > middle;
  if (is_above == (to.second > middle)) return 0;
  const Place &below = is_above ? to : from, &above = is_above ? from : to;
  const double side = (above.first - below.first) * (middle - below.second) -
                      (middle - below.first) * (above.second - below.second);
  if (!(side > 0)) return 0;
  return is_above ? -1 : 1;
}

/// True if the part of a face that projects onto the triangle is within the distance of its plane.
bool ProjectedFaces::is_within(const Places& face, double squared_limit) {
  const auto is_near = [&](const Place& place) {
    return place.away.squaredNorm() <= squared_limit;
  };
  if (std::all_of(face.begin(), face.end(), is_near)) return true;
  std::vector<Place> part(face.begin(), face.end()), rest;
  const auto clip = [&](const auto& share) {
    rest.clear();
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Place &here = part[i], &next = part[(i + 1) % part.size()];
      const double a = share(here), b = share(next);
      if (a >= 0) rest.push_back(here);
      if ((a >= 0) == (b >= 0)) continue;
      const double t = a / (a - b);
      rest.push_back({here.first + t * (next.first - here.first),
                      here.second + t * (next.second - here.second),
                      here.away + t * (next.away - here.away)});
    }
    std::swap(part, rest);
  };
  clip([](const Place& place) { return place.first; });
  clip([](const Place& place) { return place.second; });
  clip([](const Place& place) { return place.rest(); });
  return std::all_of(part.begin(), part.end(), is_near);
}

/// True if the edge ends at a corner of the triangle and certainly meets the triangle in no other
/// point. A point is beyond an edge of the triangle if the coordinate of the opposite corner is
/// negative.
bool ProjectedFaces::meets_only_corner(const Triangle& triangle, const Vec3& end,
                                       const Place& other) {
  const std::array<double, 3> shares{other.rest(), other.first, other.second};
  for (std::size_t i = 0; i < 3; ++i)
    if (end == triangle[i])
      return std::min(shares[(i + 1) % 3], shares[(i + 2) % 3]) < -share_margin;
  return false;
}

bool ProjectedFaces::covers(const Triangle& triangle, Index seed, double squared_limit,
                            std::size_t most_faces) {
  const TriangleAxes plane(triangle);
  if (!is_wide(plane)) return false;
  stamps_[seed] = ++stamp_;
  found_.assign(1, seed);
  int degree = 0;
  for (std::size_t i = 0; i < found_.size(); ++i) {
    const Index face = found_[i];
    const Triangle corners = triangle_of(mesh_, face);
    const Places places{plane.place_of(corners[0]), plane.place_of(corners[1]),
                        plane.place_of(corners[2])};
    if (!is_within(places, squared_limit)) return false;
    for (Index k = 0; k < 3; ++k) {
      const Index next = (k + 1) % 3;
      degree += turns_around_middle(places[k], places[next]);
      if (!may_meet(places[k], places[next])) continue;
      if (stops_at_corners_ && (meets_only_corner(triangle, corners[k], places[next]) ||
                                meets_only_corner(triangle, corners[next], places[k])))
        continue;
      const Index across = opposites_[3 * face + k];
      if (across == no_index || found_.size() == most_faces) return false;
      if (stamps_[across / 3] == stamp_) continue;
      stamps_[across / 3] = stamp_;
      found_.push_back(across / 3);
    }
  }
  return degree != 0;
}

}  // namespace transformesh
