#include "views/images/mask.h"

#include <doctest/doctest.h>

using namespace transformesh;

namespace {

GrayImage row(std::vector<float> intensities) {
  GrayImage image(static_cast<int>(intensities.size()), 1);
  image.pixels = std::move(intensities);
  return image;
}

using Intensities = std::vector<float>;

}  // namespace

TEST_CASE("a mask of few intensities is inside where it is not black") {
  for (const Intensities& intensities : {Intensities{0, 255, 0, 255}, Intensities{0, 1, 0, 2},
                                         Intensities{0, 40, 0, 200}, Intensities{0, 1, 0, 255}}) {
    const Mask mask = mask_of(row(intensities), {});
    CHECK(mask.rule == MaskRule::not_black);
    CHECK(mask.silhouette.pixels == Intensities{0, 255, 0, 255});
  }
  CHECK(mask_of(row({7, 7}), {}).silhouette.pixels == Intensities{255, 255});
  CHECK(mask_of(row({0, 0}), {}).silhouette.pixels == Intensities{0, 0});
}

TEST_CASE("an object before a black background keeps its dark parts") {
  const Mask mask = mask_of(row({0, 10, 30, 50, 90, 120, 150, 180, 210, 240}), {});
  CHECK(mask.rule == MaskRule::not_black);
  CHECK(mask.silhouette.pixels[1] == 255);
}

TEST_CASE("nearly black pixels are distinguished from white") {
  for (const Intensities& intensities :
       {Intensities{5, 250, 5, 250}, Intensities{0, 3, 9, 7, 2, 255, 241, 250},
        Intensities{20, 22, 90, 100}}) {
    const Mask mask = mask_of(row(intensities), {});
    CHECK(mask.rule == MaskRule::between_intensities);
    for (std::size_t i = 0; i < intensities.size(); ++i)
      CHECK(mask.silhouette.pixels[i] == (intensities[i] > 60 ? 255 : 0));
  }
}

TEST_CASE("transparency is the mask where it varies") {
  const Mask mask = mask_of(row({255, 255, 255}), row({0, 255, 100}));
  CHECK(mask.rule == MaskRule::alpha);
  CHECK(mask.silhouette.pixels == Intensities{0, 255, 0});
  const Mask opaque = mask_of(row({0, 255, 9}), row({255, 255, 255}));
  CHECK(opaque.rule == MaskRule::not_black);
  CHECK(opaque.silhouette.pixels == Intensities{0, 255, 255});
}
