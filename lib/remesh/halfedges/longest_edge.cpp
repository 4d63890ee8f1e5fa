#include "remesh/halfedges/longest_edge.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/parallel.h"

namespace transformesh {

double longest_edge_of(const EditableMesh& mesh) {
  constexpr std::size_t per_chunk = 2048;  // affects time only
  std::vector<double> longest((mesh.face_slots() + per_chunk - 1) / per_chunk, 0);
  parallel_for(longest.size(), 1, [&](std::size_t from, std::size_t to) {
    for (std::size_t part = from; part < to; ++part) {
      const auto last = std::min<std::size_t>(mesh.face_slots(), (part + 1) * per_chunk);
      double most = 0;
      for (auto face = static_cast<Index>(part * per_chunk); face < last; ++face) {
        if (!mesh.has_face(face)) continue;
        const auto [a, b, c] = mesh.triangle(face);
        most =
            std::max({most, (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
      }
      longest[part] = most;
    }
  });
  double result = 0;
  for (const double squared : longest) result = std::max(result, squared);
  return std::sqrt(result);
}

}  // namespace transformesh
