#include "tm/clean/intersect/intersect.h"

#include <memory>

#include "tm/clean/intersect/contact_points.h"
#include "tm/clean/intersect/contacts.h"
#include "tm/geometry/bvh.h"

namespace transformesh {
namespace {

// The soup face of each mesh face; no_index where it has no area.
std::vector<Index> soup_faces(const Soup& soup, std::size_t mesh_faces) {
  std::vector<Index> result(mesh_faces, no_index);
  for (Index f = 0; f < soup.faces.size(); ++f) result[soup.face_of[f]] = f;
  return result;
}

}  // namespace

std::vector<FacePair> find_intersections(const Soup& soup, const Progress& progress) {
  progress("intersect");
  std::vector<FloatBox> boxes;
  boxes.reserve(soup.faces.size());
  for (Index f = 0; f < soup.faces.size(); ++f) boxes.push_back(soup.box(f));
  const Bvh bvh(boxes);
  return bvh.overlapping_pairs([&](Index f, Index g) { return find_contacts(soup, f, g).meet; });
}

std::vector<FacePair> find_intersections(const Mesh& mesh, const Progress& progress) {
  const Soup soup = make_soup(mesh);
  std::vector<FacePair> pairs = find_intersections(soup, progress);
  // Soup faces are in mesh order, so the pairs stay sorted.
  for (auto& [f, g] : pairs) {
    f = soup.face_of[f];
    g = soup.face_of[g];
  }
  return pairs;
}

std::vector<std::pair<Vec3, Vec3>> intersection_segments(const Mesh& mesh,
                                                         const std::vector<FacePair>& pairs) {
  const Soup soup = make_soup(mesh);
  const std::vector<Index> of_mesh = soup_faces(soup, mesh.faces.size());
  const ExactGeometry geometry(soup.points, soup.faces);
  std::vector<std::pair<Vec3, Vec3>> segments;
  for (const auto& [f, g] : pairs) {
    const Index a = of_mesh[f], b = of_mesh[g];
    const Contacts contacts = find_contacts(soup, a, b);
    if (!contacts.meet || contacts.coplanar) continue;
    const auto at = [&](int i) {
      return contact_point(soup, geometry, a, b, contacts.contacts[static_cast<std::size_t>(i)])
          .center;
    };
    segments.emplace_back(at(0), at(contacts.count - 1));
  }
  return segments;
}

}  // namespace transformesh
