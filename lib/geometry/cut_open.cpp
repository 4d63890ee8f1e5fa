// Cuts a mesh at a plane and leaves the cut open; computes cross sections. Cost: O(n log n).
// Floating point.
#include <map>
#include <utility>

#include "geometry/plane_distances.h"
#include "mesh/surface_columns.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

class OpenCut {
 public:
  OpenCut(const Mesh& mesh, const CutPlane& plane) : mesh_(mesh), distances_(mesh, plane) {
    result_.positions = mesh.positions;
    result_.vertex_columns = mesh.vertex_columns;
  }

  /// Cuts the mesh. Returns true if faces were cut in two.
  bool run() {
    for (Index f = 0; f < mesh_.faces.size(); ++f) add(f);
    if (result_.faces.empty())
      throw GoalError("nothing of the mesh lies on the side that the plane's normal points to");
    result_.face_columns = mesh_.face_columns.select(faces_);
    if (!new_vertices_.empty()) drop_corner_lists(result_.face_columns);
    result_ = select_faces(result_, std::vector<bool>(result_.faces.size(), true));
    return !new_vertices_.empty();
  }

  Mesh take() { return std::move(result_); }

 private:
  void add(Index f) {
    const Face& face = mesh_.faces[f];
    bool is_behind = true, is_in_plane = true;
    for (const Index v : face) {
      is_behind = is_behind && distances_[v] <= 0;
      is_in_plane = is_in_plane && distances_[v] == 0;
    }
    // Drop a face in the plane unless its normal is opposite to the normal of the plane. Only such
    // a face bounds the part in front of the plane.
    if (is_in_plane ? face_normal(mesh_, f).dot(distances_.normal()) >= 0 : is_behind) return;
    add_polygon(part_in_front(face), f);
  }

  std::vector<Index> part_in_front(const Face& face) {
    std::vector<Index> polygon;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = face[i], b = face[(i + 1) % 3];
      if (distances_[a] >= 0) polygon.push_back(a);
      if (distances_.is_crossed(a, b)) polygon.push_back(new_vertex(a, b));
    }
    return polygon;
  }

  Index new_vertex(Index a, Index b) {
    const auto [low, high] = std::minmax(a, b);
    const auto [entry, is_new] = new_vertices_.try_emplace(
        std::pair(low, high), static_cast<Index>(result_.positions.size()));
    if (!is_new) return entry->second;
    const PlaneDistances::Crossing crossing = distances_.crossing(a, b);
    result_.positions.push_back(crossing.position);
    result_.vertex_columns.append({{low, high}, {1 - crossing.weight, crossing.weight, 0}});
    return entry->second;
  }

  void add_polygon(const std::vector<Index>& polygon, Index face) {
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      result_.faces.push_back({polygon[0], polygon[i - 1], polygon[i]});
      faces_.push_back(face);
    }
  }

  const Mesh& mesh_;
  PlaneDistances distances_;
  Mesh result_;
  std::vector<Index> faces_;  ///< for each face of the result, the input face that contains it
  std::map<std::pair<Index, Index>, Index> new_vertices_;
};

}  // namespace

bool cut_open(Mesh& mesh, const CutPlane& plane) {
  OpenCut cut(mesh, plane);
  const bool has_cut = cut.run();
  mesh = cut.take();
  return has_cut;
}

std::vector<std::pair<Vec3, Vec3>> plane_section(const Mesh& mesh, const CutPlane& plane) {
  const PlaneDistances distances(mesh, plane);
  const auto is_front = [&](Index v) { return distances[v] >= 0; };
  std::vector<std::pair<Vec3, Vec3>> segments;
  for (const Face& face : mesh.faces) {
    std::pair<Vec3, Vec3> segment;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = face[i], b = face[(i + 1) % 3];
      if (is_front(a) == is_front(b)) continue;
      (is_front(a) ? segment.first : segment.second) = distances.crossing(a, b).position;
      ++count;
    }
    if (count == 2 && segment.first != segment.second) segments.push_back(segment);
  }
  return segments;
}

}  // namespace transformesh
