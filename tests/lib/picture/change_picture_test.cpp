/// Colors of a picture of changes, checked by counting pixels in its four panels.
#include "picture/change_picture.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"

using namespace transformesh;

namespace {

/// Counts the pixels of a panel in which one channel is far above both others.
std::size_t count_colored(const Image& image, int channel, int left, int above) {
  std::size_t count = 0;
  for (int y = above; y < above + image.height / 2; ++y)
    for (int x = left; x < left + image.width / 2; ++x) {
      const Pixel& pixel = image.at(x, y);
      const auto i = static_cast<std::size_t>(channel);
      count += pixel[i] > pixel[(i + 1) % 3] + 40 && pixel[i] > pixel[(i + 2) % 3] + 40 ? 1 : 0;
    }
  return count;
}

}  // namespace

TEST_CASE("lost faces are red to the left, new ones green to the right, from both sides") {
  const Mesh ball = test::icosphere(3);
  const Mesh before = test::joined(ball, test::moved(test::icosphere(2), Vec3(3, 0, 0)));
  const Mesh after = test::joined(ball, test::moved(test::icosphere(2), Vec3(0, 3, 0)));
  ChangePictureOptions options;
  options.width = 400;
  options.height = 300;
  options.is_lost.assign(before.faces.size(), 1);
  std::fill_n(options.is_lost.begin(), ball.faces.size(), 0);
  options.is_new.assign(after.faces.size(), 1);
  std::fill_n(options.is_new.begin(), ball.faces.size(), 0);
  const Image image = draw_change(before, after, options);
  CHECK(image.width == 400);
  CHECK(image.height == 300);
  for (const int above : {0, 150}) {
    CAPTURE(above);
    CHECK(count_colored(image, 0, 0, above) > 300);
    CHECK(count_colored(image, 0, 200, above) == 0);
    CHECK(count_colored(image, 1, 0, above) == 0);
    CHECK(count_colored(image, 1, 200, above) > 300);
  }
}
