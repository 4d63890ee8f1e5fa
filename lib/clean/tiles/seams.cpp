#include "clean/tiles/seams.h"

#include <algorithm>

#include "clean/exterior/angular_order.h"
#include "clean/stitch/pair_halfedges.h"
#include "clean/stitch/weld.h"
#include "mesh/disjoint_sets.h"
#include "transformesh/errors.h"

namespace transformesh {

void Seams::find_borders(const std::vector<Face>& faces, std::size_t vertices) {
  const auto first = static_cast<Index>(vertex_of_.size());
  parts_.push_back({vertices, first, 0});
  border_vertices_.clear();
  border_faces_.clear();
  const Edges edges(faces, vertices);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    if (halfedges.size() > 2)
      throw InputError("faces " + std::to_string(halfedges[0] / 3) + " and " +
                       std::to_string(halfedges[1] / 3) + " share an edge with a third face");
    if (halfedges.size() == 2) continue;
    const Index h = halfedges[0];
    const Face& face = faces[h / 3];
    border_faces_.push_back({face[h % 3], face[(h % 3 + 1) % 3], face[(h % 3 + 2) % 3]});
    border_vertices_.push_back(border_faces_.back().from);
    border_vertices_.push_back(border_faces_.back().to);
  }
  std::sort(border_vertices_.begin(), border_vertices_.end());
  border_vertices_.erase(std::unique(border_vertices_.begin(), border_vertices_.end()),
                         border_vertices_.end());
}

void Seams::keep_borders() {
  const Index first = parts_.back().first_border;
  const auto border_vertex = [&](Index v) {
    const auto place = std::lower_bound(border_vertices_.begin(), border_vertices_.end(), v);
    return first + static_cast<Index>(place - border_vertices_.begin());
  };
  for (const BorderFace& face : border_faces_)
    halfedges_.push_back({border_vertex(face.from), border_vertex(face.to), 0});
  vertex_of_.insert(vertex_of_.end(), border_vertices_.begin(), border_vertices_.end());
}

// Makes a mesh of one triangle per border halfedge, and pairs its halfedges. Each triangle has its
// own vertex at the third corner of the original face, so that the triangles can be sorted by angle
// around edges.
std::size_t Seams::join() {
  const std::vector<Index> place = weld_positions(positions_, 0);
  Mesh borders;
  borders.positions = positions_;
  borders.positions.insert(borders.positions.end(), apexes_.begin(), apexes_.end());
  for (const Face& halfedge : halfedges_)
    borders.faces.push_back({place[halfedge[0]], place[halfedge[1]],
                             static_cast<Index>(positions_.size() + borders.faces.size())});
  const std::vector<Index> opposite = pair_across_inside(
      borders.faces, Edges(borders),
      [&](std::span<const Index> halfedges) { return sort_around_edge(borders, halfedges); });

  DisjointSets joined(positions_.size());
  std::size_t left = 0;
  for (std::size_t i = 0; i < halfedges_.size(); ++i) {
    const Index across = opposite[3 * i];
    if (across == no_index) {
      ++left;
      continue;
    }
    joined.join(halfedges_[i][0], halfedges_[across / 3][1]);
    joined.join(halfedges_[i][1], halfedges_[across / 3][0]);
  }
  first_.resize(positions_.size());
  for (Index v = 0; v < first_.size(); ++v) first_[v] = joined.find(v);
  number_vertices();
  return left;
}

void Seams::number_vertices() {
  number_.resize(first_.size());
  vertex_count_ = 0;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    Part& part = parts_[p];
    part.first_number = static_cast<Index>(vertex_count_);
    const std::size_t end = p + 1 < parts_.size() ? parts_[p + 1].first_border : first_.size();
    std::size_t repeated = 0;
    for (std::size_t v = part.first_border; v < end; ++v) {
      number_[v] = first_[v] == v ? static_cast<Index>(part.first_number + vertex_of_[v] - repeated)
                                  : number_[first_[v]];
      repeated += first_[v] == v ? 0 : 1;
    }
    vertex_count_ += part.vertices - repeated;
    if (vertex_count_ >= no_index)
      throw InputError("the joined mesh has more than 4294967294 vertices, which is not supported");
  }
}

std::vector<bool> Seams::is_repeated(std::size_t mesh) const {
  const Part& part = parts_[mesh];
  const std::size_t end =
      mesh + 1 < parts_.size() ? parts_[mesh + 1].first_border : vertex_of_.size();
  std::vector<bool> result(part.vertices, false);
  for (std::size_t v = part.first_border; v < end; ++v)
    if (first_[v] != v) result[vertex_of_[v]] = true;
  return result;
}

std::vector<Index> Seams::numbers_of(std::size_t mesh) const {
  const Part& part = parts_[mesh];
  const std::vector<bool> repeated = is_repeated(mesh);
  std::vector<Index> result(part.vertices, no_index);
  Index next = part.first_number;
  for (std::size_t v = 0; v < result.size(); ++v)
    if (!repeated[v]) result[v] = next++;
  const std::size_t end =
      mesh + 1 < parts_.size() ? parts_[mesh + 1].first_border : vertex_of_.size();
  for (std::size_t v = part.first_border; v < end; ++v) result[vertex_of_[v]] = number_[v];
  return result;
}

}  // namespace transformesh
