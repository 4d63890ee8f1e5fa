#include "tm/clean/intersect/intersect.h"

#include <memory>

#include "tm/clean/intersect/contacts.h"
#include "tm/geometry/bvh.h"

namespace transformesh {
namespace {

// The welded face of each mesh face; no_index where it has no area.
std::vector<Index> welded_faces(const WeldedMesh& welded, std::size_t mesh_faces) {
  std::vector<Index> result(mesh_faces, no_index);
  for (Index f = 0; f < welded.faces.size(); ++f) result[welded.face_of[f]] = f;
  return result;
}

}  // namespace

std::vector<FacePair> find_intersections(const WeldedMesh& welded, const Progress& progress) {
  progress("intersect");
  std::vector<FloatBox> boxes;
  boxes.reserve(welded.faces.size());
  for (Index f = 0; f < welded.faces.size(); ++f) boxes.push_back(welded.box(f));
  const Bvh bvh(boxes);
  return bvh.overlapping_pairs([&](Index f, Index g) { return find_contacts(welded, f, g).meet; });
}

std::vector<FacePair> find_intersections(const Mesh& mesh, const Progress& progress) {
  const WeldedMesh welded = weld(mesh);
  std::vector<FacePair> pairs = find_intersections(welded, progress);
  // Welded faces are in the order of the mesh, so the pairs stay sorted.
  for (auto& [f, g] : pairs) {
    f = welded.face_of[f];
    g = welded.face_of[g];
  }
  return pairs;
}

std::vector<std::pair<Vec3, Vec3>> intersection_segments(const Mesh& mesh,
                                                         const std::vector<FacePair>& pairs) {
  const WeldedMesh welded = weld(mesh);
  const std::vector<Index> of_mesh = welded_faces(welded, mesh.faces.size());
  const ExactGeometry geometry(welded.points, welded.faces);
  std::vector<std::pair<Vec3, Vec3>> segments;
  for (const auto& [f, g] : pairs) {
    const Index a = of_mesh[f], b = of_mesh[g];
    const Contacts contacts = find_contacts(welded, a, b);
    if (!contacts.meet || contacts.coplanar) continue;
    const auto at = [&](int i) {
      return contact_point(welded, geometry, a, b, contacts.contacts[static_cast<std::size_t>(i)])
          .center;
    };
    segments.emplace_back(at(0), at(contacts.count - 1));
  }
  return segments;
}

}  // namespace transformesh
