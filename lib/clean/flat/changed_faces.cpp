#include "clean/flat/changed_faces.h"

#include <algorithm>
#include <array>

namespace transformesh {
namespace {

using Place = std::array<double, 3>;

Place place_of(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

/// Returns the positions of the corners of all input faces that are not faces of the result,
/// sorted.
std::vector<Place> corners_of_lost_faces(const Mesh& input, std::span<const Index> source_face,
                                         std::span<const char> face_is_new) {
  std::vector<char> is_left(input.faces.size(), 0);
  for (std::size_t f = 0; f < source_face.size(); ++f)
    if (!face_is_new[f]) is_left[source_face[f]] = 1;
  std::vector<Place> places;
  for (std::size_t f = 0; f < is_left.size(); ++f)
    if (!is_left[f])
      for (const Index v : input.faces[f]) places.push_back(place_of(input.positions[v]));
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace

std::vector<char> find_changed_faces(const Mesh& input, const Mesh& result,
                                     std::span<const Index> source_face,
                                     std::span<const char> face_is_new) {
  const std::vector<Place> places = corners_of_lost_faces(input, source_face, face_is_new);
  std::vector<char> is_at_lost(result.positions.size(), 0);
  for (std::size_t v = 0; v < is_at_lost.size(); ++v)
    is_at_lost[v] =
        std::binary_search(places.begin(), places.end(), place_of(result.positions[v])) ? 1 : 0;
  std::vector<char> changed(face_is_new.begin(), face_is_new.end());
  for (std::size_t f = 0; f < changed.size(); ++f)
    for (const Index v : result.faces[f]) changed[f] = changed[f] | is_at_lost[v];
  return changed;
}

}  // namespace transformesh
