#include "tm/geometry/degenerate_faces.h"

#include "tm/geometry/predicates.h"
#include "tm/support/parallel.h"

namespace transformesh {

std::vector<Index> degenerate_faces(const Mesh& mesh) {
  constexpr std::size_t faces_per_task = 4096;
  std::vector<char> is_degenerate(mesh.faces.size());
  parallel_for(mesh.faces.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      const auto& [a, b, c] = mesh.faces[f];
      is_degenerate[f] = collinear(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    }
  });
  std::vector<Index> result;
  for (std::size_t f = 0; f < is_degenerate.size(); ++f)
    if (is_degenerate[f]) result.push_back(static_cast<Index>(f));
  return result;
}

}  // namespace transformesh
