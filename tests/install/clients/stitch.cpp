// Stitches the separate triangles of a sphere, one of them reversed, into an oriented sphere.
#include <transformesh/shapes.h>
#include <transformesh/stitch.h>

#include <cmath>

using namespace transformesh;

int main() {
  const Mesh sphere = make_sphere(Vec3::Zero(), 1, 500);
  Mesh soup;
  for (const Face& f : sphere.faces) {
    const auto first = static_cast<Index>(soup.positions.size());
    for (const Index v : f) soup.positions.push_back(sphere.positions[v]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  std::swap(soup.faces[0][0], soup.faces[0][1]);
  Mesh misoriented = soup;
  const StitchResult before = stitch(misoriented);
  if (before.misoriented_edges != 3 || !before.can_be_oriented) return 1;
  const StitchResult result = stitch(soup, {.orient = true});
  if (result.reversed_faces != 1 || result.border_edges != 0) return 1;
  if (soup.positions.size() != sphere.positions.size() || soup.faces.size() != 500) return 1;
  return std::abs(volume(soup) - volume(sphere)) < 1e-9 ? 0 : 1;
}
