#include "fill/slit.h"

#include <algorithm>

namespace transformesh {
namespace {

/// Fraction of the way to the mean of their neighbors by which the vertices of both sides move away
/// from the slit. A choice: with less, both sides stay close together; with more, the surface is
/// deformed.
constexpr double drawn_back = 1.0 / 3;

/// Adds the data of a loop vertex to a side of the slit. `corners` are the outgoing halfedges of
/// the vertex on this side, starting with the one along the loop.
void add_vertex(const Mesh& mesh, const std::vector<Index>& loop, std::vector<Index> corners,
                SlitSide& side) {
  const Index vertex = halfedge_source(mesh, corners.front());
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (const Index h : corners) {
    const Index neighbor = halfedge_target(mesh, h);
    if (std::find(loop.begin(), loop.end(), neighbor) == loop.end()) {
      sum += mesh.positions[neighbor] - mesh.positions[vertex];
      ++count;
    } else if (h != corners.front()) {
      side.chords.emplace_back(vertex, neighbor);
    }
  }
  side.corners.push_back(std::move(corners));
  side.drawn_back.push_back(mesh.positions[vertex]);
  if (count > 0) side.drawn_back.back() += drawn_back / count * sum;
}

}  // namespace

SlitSides sides_of(const Mesh& mesh, const std::vector<Index>& loop, const HalfedgeStars& stars) {
  SlitSides sides;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Index next = loop[(i + 1) % loop.size()];
    const Index previous = loop[(i + loop.size() - 1) % loop.size()];
    const std::vector<Index> all = stars.from(mesh, loop[i], next);
    const auto middle = std::find_if(all.begin(), all.end(),
                                     [&](Index h) { return halfedge_target(mesh, h) == previous; });
    add_vertex(mesh, loop, {all.begin(), middle}, sides.left);
    add_vertex(mesh, loop, {middle, all.end()}, sides.right);
  }
  return sides;
}

void slit_along(Mesh& mesh, const std::vector<Index>& loop, const SlitSides& sides) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto copy = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(mesh.positions[loop[i]]);
    mesh.vertex_columns.append(RowBlend{{loop[i]}});
    for (const Index corner : sides.right.corners[i]) mesh.faces[corner / 3].at(corner % 3) = copy;
  }
}

}  // namespace transformesh
