#include "views/cameras/image_files.h"

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

TEST_CASE("cameras without an image, and images without a camera, are left out with a note") {
  const Folder folder;
  folder.write("par.txt", middlebury({"a.png", "b.png", "c.png", "d.png", "e.png"}));
  for (const char* name : {"a", "b", "d"})
    folder.write("images/" + std::string(name) + ".pgm", image(5, 3, name[0]));
  std::string notes;
  ViewSources sources{folder.at("par.txt"), folder.at("images"), ""};
  sources.on_note = [&](const std::string& note) { notes += note + "\n"; };
  const auto views = views_from(sources);
  REQUIRE(views.size() == 3);
  CHECK(views[2].name == "d");
  CHECK(views[2].image.at(0, 0) == 'd');
  CHECK(views[2].camera.intrinsics(0, 0) == 103);
  CHECK(says(notes, "2 cameras without image in "));
  CHECK(says(notes, "c.png ("));
  CHECK(picture_views_from(sources).size() == 3);
  CHECK(cameras_of_images(cameras_from(sources.cameras), sources).cameras.size() == 3);
  sources.needs_all_images = true;
  CHECK(says(refusal(sources), "c.png"));
  sources.needs_all_images = false;
  // Fewer than three are most likely a mistake.
  std::filesystem::remove(folder.at("images/a.pgm"));
  CHECK(says(refusal(sources), "a.png"));

  notes.clear();
  for (const char* name : {"a", "c", "e", "f"})
    folder.write("images/" + std::string(name) + ".pgm", image(5, 3, name[0]));
  CHECK(views_from(sources).size() == 5);
  CHECK(says(notes, "1 image in "));
  CHECK(says(notes, "f.pgm"));
  // Names that are shifted by one are not left out.
  std::filesystem::remove(folder.at("images/a.pgm"));
  CHECK(says(refusal(sources), "a.png"));
}

TEST_CASE("masks of photographs that are left out are left out, too") {
  const Folder folder;
  folder.write("par.txt", middlebury({"a.png", "b.png", "c.png", "d.png"}));
  for (const char* name : {"a", "b", "c", "d"}) {
    folder.write("masks/" + std::string(name) + "_mask.pgm", image(5, 3, 255));
    if (name[0] != 'b') folder.write("images/" + std::string(name) + ".pgm", image(5, 3, name[0]));
  }
  const auto views = views_from({folder.at("par.txt"), folder.at("images"), folder.at("masks")});
  REQUIRE(views.size() == 3);
  CHECK(views[1].name == "c");
  CHECK(views[1].silhouette.at(0, 0) == 255);
}
