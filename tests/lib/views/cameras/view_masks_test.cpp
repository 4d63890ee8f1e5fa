#include "views/cameras/view_masks.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "helpers/view_folder.h"
#include "views/cameras/view.h"

using namespace transformesh;
using test::Folder;
using test::image;
using test::middlebury;
using test::refusal;
using test::says;

TEST_CASE("a mask of another size and the same shape is scaled to its photograph") {
  const Folder folder;
  folder.write("par.txt", middlebury({"a.png"}));
  folder.write("images/a.pgm", image(8, 6, 9));
  std::string notes;
  ViewSources sources{folder.at("par.txt"), folder.at("images"), folder.at("masks")};
  sources.on_note = [&](const std::string& note) { notes += note + "\n"; };
  // The left half of each mask is the object. The masks have half and twice the photograph's size.
  for (const int width : {4, 16}) {
    std::string mask = image(width, width * 3 / 4, 0);
    const std::size_t first = mask.size() - static_cast<std::size_t>(width * width * 3 / 4);
    for (std::size_t i = 0; first + i < mask.size(); ++i)
      if (static_cast<int>(i) % width < width / 2) mask[first + i] = '\xff';
    folder.write("masks/a.pgm", mask);
    notes.clear();
    const auto views = views_from(sources);
    CHECK(views[0].silhouette.width == 8);
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 8; ++x) CHECK(views[0].silhouette.at(x, y) == (x < 4 ? 255 : 0));
    CHECK(says(notes, "scaled"));
  }
  for (const int width : {7, 9, 16}) {
    folder.write("masks/a.pgm", image(width, 6, 255));
    CHECK(says(refusal(sources), "8 x 6"));
  }
}
