#include "tm/clean/intersect/contact_points.h"

#include <algorithm>

namespace transformesh {
namespace {

std::array<Index, 2> edge(const Soup& soup, Index face, Place place) {
  const Index u = soup.faces[face][place - 3U];
  const Index v = soup.faces[face][(place - 2U) % 3];
  return {std::min(u, v), std::max(u, v)};
}

}  // namespace

ExactPoint contact_point(const Soup& soup, const ExactGeometry& geometry, Index first, Index second,
                         Contact contact) {
  if (contact.first < 3) return geometry.given(soup.faces[first][contact.first]);
  if (contact.second < 3) return geometry.given(soup.faces[second][contact.second]);
  if (contact.second == interior) {
    const auto [u, v] = edge(soup, first, contact.first);
    return geometry.line_plane(u, v, second);
  }
  const auto [x, y] = edge(soup, second, contact.second);
  if (contact.first == interior) return geometry.line_plane(x, y, first);

  // Two edges cross: the same definition from whichever faces they are seen.
  const auto [u, v] = edge(soup, first, contact.first);
  return geometry.line_line(u, v, x, y);
}

}  // namespace transformesh
