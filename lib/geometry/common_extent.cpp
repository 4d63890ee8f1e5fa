#include "geometry/common_extent.h"

#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Between these extents, squares of areas neither overflow nor vanish.
constexpr double largest_extent = 1e75;
constexpr double smallest_extent = 1e-75;

}  // namespace

void check_common_extent(const Mesh& mesh, const Mesh& reference, const std::string& purpose) {
  const Box a = bounding_box(mesh);
  const Box b = bounding_box(reference);
  const double extent = diagonal_of({a.min().cwiseMin(b.min()), a.max().cwiseMax(b.max())});
  if (extent > 0 && extent < smallest_extent)
    throw InputError("the meshes are " + shortest_text(extent) + " across, too small " + purpose +
                     ": scale both by the same factor to at least " +
                     shortest_text(smallest_extent));
  if (!(extent < largest_extent))
    throw InputError("the meshes are " + shortest_text(extent) + " across, too large " + purpose +
                     ": scale both by the same factor to less than " +
                     shortest_text(largest_extent));
}

}  // namespace transformesh
