#include "views/hull/keep_in_box.h"

#include <algorithm>

#include "shapes/boxes.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "views/cameras/view.h"
#include "views/hull/silhouette.h"

namespace transformesh {
namespace {

/// True if pixel (x, y) or one of its eight neighbors is inside the silhouette.
bool is_near(const GrayImage& silhouette, int x, int y) {
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, silhouette.height - 1); ++j)
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, silhouette.width - 1); ++i)
      if (silhouette.at(i, j) > 0) return true;
  return false;
}

/// Sets all pixels of `held` to 0, except for those inside the silhouette `box` and their
/// neighbors.
void blacken(PackableImage& held, const GrayImage& box) {
  if (held.empty()) return;
  const bool is_packed = held.is_packed();
  GrayImage image = held;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (!is_near(box, x, y)) image.at(x, y) = 0;
  held = std::move(image);
  if (is_packed) held.pack();
}

}  // namespace

void keep_in_box(std::vector<View>& views, const Box& box) {
  const Vec3 size = box.max() - box.min();
  if (!(size.allFinite() && size.minCoeff() > 0))
    throw UsageError(
        "the box is empty: each coordinate of its first corner must be less than that of its "
        "second corner");
  Mesh surface = shapes::box(size, 12);
  for (Vec3& position : surface.positions) position += (box.min() + box.max()) / 2;
  parallel_for(views.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const GrayImage shown = mesh_silhouette(surface, views[i]);
      if (inside_share(shown) == 0)
        throw InputError(
            views[i].name +
            ": the box is outside this view; check that its units are those of the cameras");
      blacken(views[i].image, shown);
      blacken(views[i].silhouette, shown);
    }
  });
}

}  // namespace transformesh
