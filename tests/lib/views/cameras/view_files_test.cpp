#include "views/cameras/view_files.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "helpers/view_folder.h"
#include "transformesh/errors.h"
#include "views/cameras/view.h"

using namespace transformesh;
using test::Folder;
using test::image;
using test::middlebury;
using test::refusal;
using test::says;

namespace {

std::string numbered(const std::string& start, int number, const std::string& end) {
  return start + std::to_string(number) + end;
}

// A 3x4 matrix whose camera has this focal length.
std::string matrix(int focal) {
  const std::string f = std::to_string(focal);
  return f + " 0 2 0\n0 " + f + " 1 0\n0 0 1 5\n";
}

}  // namespace

TEST_CASE("cameras of their own files pair with images of the same stem") {
  const Folder folder;
  folder.write("cameras/b.txt", matrix(200));
  folder.write("cameras/a.txt", matrix(100));
  folder.write("images/a.pgm", image(5, 3, 10));
  folder.write("images/b.pgm", image(5, 3, 20));
  folder.write("images/readme.txt", "no image");
  const auto views = views_from({folder.at("cameras"), folder.at("images"), ""});
  REQUIRE(views.size() == 2);
  CHECK(views[0].name == "a");
  CHECK(views[0].camera.intrinsics(0, 0) == doctest::Approx(100));
  CHECK(views[0].image.at(4, 2) == 10);
  CHECK(views[0].silhouette.empty());
  CHECK(views[1].camera.intrinsics(0, 0) == doctest::Approx(200));
  CHECK(views[1].image.at(0, 0) == 20);
}

TEST_CASE("views are read smaller, with their cameras") {
  const Folder folder;
  folder.write("cameras/a.txt", matrix(100));
  folder.write("images/a.pgm", image(4, 2, 10));
  folder.write("masks/a.pgm", image(4, 2, 255));
  ViewSources sources{folder.at("cameras"), folder.at("images"), folder.at("masks")};
  sources.reduction = 2;
  const auto views = views_from(sources);
  REQUIRE(views.size() == 1);
  CHECK(views[0].image.width == 2);
  CHECK(views[0].image.height == 1);
  CHECK(views[0].image.at(1, 0) == doctest::Approx(10));
  CHECK(views[0].silhouette.width == 2);
  CHECK(views[0].camera.intrinsics(0, 0) == doctest::Approx(50));
  // The corners of the image keep their directions: column -.5 stays, 3.5 becomes 1.5.
  CHECK(views[0].camera.intrinsics(0, 2) == doctest::Approx((2 + 0.5) / 2 - 0.5));
}

TEST_CASE("cameras that name their images find them in any order and with any extension") {
  const Folder folder;
  folder.write("par.txt", middlebury({"b.png", "a.png"}));
  folder.write("images/a.pgm", image(5, 3, 10));
  folder.write("images/b.ppm", "P3 1 1 255 20 20 20");
  folder.write("images/.hidden.pgm", image(5, 3, 10));
  const auto views = views_from({folder.at("par.txt"), folder.at("images"), ""});
  REQUIRE(views.size() == 2);
  CHECK(views[0].name == "b");
  CHECK(views[0].image.at(0, 0) == doctest::Approx(20));
  CHECK(views[0].camera.intrinsics(0, 0) == 100);
  CHECK(views[1].name == "a");
}

TEST_CASE("without common names the natural order decides, with numbers as numbers") {
  const Folder folder;
  for (const int i : {0, 2, 9, 10}) {
    folder.write(numbered("cameras/c", i, ".txt"), matrix(100 + i));
    folder.write(numbered("images/view_", i + 1, ".pgm"), image(4, 4, i));
  }
  const auto views = views_from({folder.at("cameras/*.txt"), folder.at("images/*.pgm"), ""});
  REQUIRE(views.size() == 4);
  for (const View& view : views) {
    CHECK(view.camera.intrinsics(0, 0) - 100 ==
          doctest::Approx(static_cast<double>(view.image.at(0, 0))));
  }
  CHECK(views[3].name == "view_11");
}

TEST_CASE("silhouettes may have a suffix of their own") {
  const Folder folder;
  folder.write("par.txt", middlebury({"v1.png", "v2.png"}));
  for (const std::string name : {"v1", "v2"}) {
    folder.write("all/" + name + ".pgm", image(2, 1, 50));
    folder.write("all/" + name + "-mask.pgm", std::string("P5 2 1 255\n\0\1", 13));
  }
  const ViewSources sources{folder.at("par.txt"), folder.at("all/v?.pgm"),
                            folder.at("all/*-mask.pgm")};
  const auto views = views_from(sources);
  REQUIRE(views.size() == 2);
  CHECK(views[1].name == "v2");
  CHECK(views[1].silhouette.at(0, 0) == 0);
  CHECK(views[1].silhouette.at(1, 0) == 255);
  const auto without_images = views_from({sources.cameras, "", sources.silhouettes});
  CHECK(without_images[1].image.empty());
  CHECK(without_images[1].silhouette.at(1, 0) == 255);
  CHECK(without_images[1].camera.intrinsics(0, 0) == 101);
}

TEST_CASE("masks named as COLMAP names them, by the whole name of the image") {
  const Folder folder;
  folder.write("par.txt", middlebury({"v2.jpg", "v1.jpg"}));
  folder.write("masks/v1.jpg.pgm", image(2, 1, 1));
  folder.write("masks/v2.jpg.pgm", image(2, 2, 1));
  const auto views = views_from({folder.at("par.txt"), "", folder.at("masks")});
  REQUIRE(views.size() == 2);
  CHECK(views[0].silhouette.height == 2);
}

TEST_CASE("of several bad images the first is named, whatever the threads") {
  const Folder folder;
  std::vector<std::string> names;
  for (int i = 100; i < 140; ++i) {
    names.push_back(numbered("v", i, ".pgm"));
    folder.write("images/" + names.back(), i < 107 ? image(2, 1, 1) : "P5 2 2 255\n");
  }
  folder.write("par.txt", middlebury(names));
  for (int round = 0; round < 20; ++round) {
    CHECK(says(refusal({folder.at("par.txt"), folder.at("images"), ""}), "v107.pgm"));
  }
}

TEST_CASE("names of which only some agree are refused") {
  const Folder folder;
  folder.write("par.txt", middlebury({"v1.png", "v2.png", "v3.png"}));
  for (const int i : {0, 1, 2, 3}) {
    folder.write(numbered("images/v", i, ".pgm"), image(4, 4, 9));
    folder.write(numbered("masks/v", i, "_mask.pgm"), image(4, 4, 9));
    folder.write(numbered("cameras/v", i, ".txt"), matrix(100));
  }
  const std::string shifted = folder.at("images/v[012].pgm");
  const std::string message = refusal({folder.at("par.txt"), shifted, ""});
  CHECK(says(message, "v3.png (" + folder.at("par.txt") + " line 4)"));
  CHECK(says(refusal({folder.at("cameras/v[123].txt"), shifted, ""}), "v3"));
  CHECK(says(refusal({folder.at("par.txt"), "", folder.at("masks/v[012]*")}), "v3.png"));
  CHECK(says(
      refusal({folder.at("par.txt"), folder.at("images/v[123].pgm"), folder.at("masks/v[012]*")}),
      "v3.pgm"));
  // The names of images in a camera file must match the files.
  folder.write("other/a.pgm", image(4, 4, 9));
  folder.write("other/b.pgm", image(4, 4, 9));
  folder.write("other/c.pgm", image(4, 4, 9));
  CHECK(says(refusal({folder.at("par.txt"), folder.at("other"), ""}), "v1.png"));
}

TEST_CASE("different counts are refused, and missing files named") {
  const Folder folder;
  folder.write("par.txt", middlebury({"v1.png", "v2.png"}));
  folder.write("cameras/c1.txt", matrix(100));
  folder.write("cameras/c2.txt", matrix(100));
  folder.write("images/v1.pgm", image(4, 4, 9));
  const std::string one = folder.at("images/v1.pgm");
  CHECK(says(refusal({folder.at("par.txt"), one, ""}), "v2.png"));
  CHECK(says(refusal({folder.at("par.txt"), one, ""}), "2 cameras, but 1 image"));
  CHECK(says(refusal({folder.at("cameras"), one, ""}), "2 cameras, but 1 image"));
  folder.write("images/v2.pgm", image(4, 4, 9));
  folder.write("images/v3.pgm", image(4, 4, 9));
  // An image without a camera is left out, unless all images are required.
  ViewSources sources{folder.at("par.txt"), folder.at("images"), ""};
  std::string notes;
  sources.on_note = [&](const std::string& note) { notes += note; };
  CHECK(refusal(sources).empty());
  CHECK(says(notes, "v3.pgm"));
  sources.needs_all_images = true;
  CHECK(says(refusal(sources), "v3.pgm"));
}

TEST_CASE("impossible sizes are refused") {
  const Folder folder;
  folder.write("a.txt", matrix(100));
  folder.write("a.pgm", image(5, 3, 10));
  folder.write("wide.pgm", image(10, 3, 10));
  CHECK(says(refusal({folder.at("a.txt"), folder.at("a.pgm"), folder.at("wide.pgm")}),
             folder.at("wide.pgm") + ": the silhouette has 10 x 3 pixels"));
  folder.write("colmap/cameras.txt", "1 SIMPLE_PINHOLE 5 4 9 2 2\n");
  folder.write("colmap/images.txt", "1 1 0 0 0 0 0 5 1 a.png\n\n");
  CHECK(says(refusal({folder.at("colmap"), folder.at("a.pgm"), ""}), "5 x 4"));
  CHECK(says(refusal({folder.at("colmap"), folder.at("a.pgm"), ""}), "images.txt line 1"));
  // The first camera has another lens.
  for (const std::string name : {"a", "b", "c"}) {
    folder.write("cameras/" + name + ".txt", matrix(name == "a" ? 90 : 100));
    folder.write("images/" + name + ".pgm", image(5, name == "b" ? 3 : 4, 10));
  }
  CHECK(
      says(refusal({folder.at("cameras"), folder.at("images"), ""}), "c.pgm: the image has 5 x 4"));
  folder.write("cameras/c.txt", matrix(110));
  CHECK(refusal({folder.at("cameras"), folder.at("images"), ""}).empty());
}

TEST_CASE("a silhouette without a pixel inside is refused by its name") {
  const Folder folder;
  folder.write("a.txt", matrix(100));
  folder.write("a.pgm", image(5, 3, 0));
  CHECK(says(refusal({folder.at("a.txt"), "", folder.at("a.pgm")}),
             folder.at("a.pgm") + ": the silhouette is empty"));
}

TEST_CASE("files that are not there or not what they should be are named") {
  const Folder folder;
  folder.write("a.txt", matrix(100));
  folder.write("a.pgm", image(5, 3, 10).substr(0, 15));
  folder.write("text/readme.txt", "no camera");
  CHECK(says(refusal({folder.at("none.txt"), "", ""}), "none.txt"));
  CHECK(says(refusal({folder.at("n*.txt"), "", ""}), "no file matches"));
  CHECK(says(refusal({folder.at("text"), "", ""}), "no camera file"));
  CHECK(says(refusal({folder.at("a.txt"), folder.at("text"), ""}), "no image in this folder"));
  CHECK(says(refusal({folder.at("a.txt"), folder.at("a.pgm"), ""}), "a.pgm"));
  CHECK(says(refusal({folder.at("text/readme.txt"), "", ""}), "not a camera file"));
  folder.write("binary/cameras.bin", std::string("\1\0\0\0\0\0\0\0", 8));
  CHECK(says(refusal({folder.at("binary"), "", ""}), "no camera file"));
  folder.write("binary/images.bin", std::string("\1\0\0\0\0\0\0\0", 8));
  CHECK(says(refusal({folder.at("binary"), "", ""}), "ends too early"));
  folder.write("mixed/a.txt", matrix(100));
  folder.write("mixed/par.txt", middlebury({"a.png"}));
  CHECK(says(refusal({folder.at("mixed"), "", ""}), "different formats"));
  folder.write("twice/a.txt", middlebury({"a.png"}));
  folder.write("twice/b.txt", middlebury({"a.png"}));
  CHECK(says(refusal({folder.at("twice"), "", ""}), "b.txt line 2"));
}

TEST_CASE("COLMAP's two files are found from either, and by their folder") {
  const Folder folder;
  folder.write("cameras.txt", "1 SIMPLE_PINHOLE 5 3 9 2 2\n");
  folder.write("images.txt", "# a comment\n1 1 0 0 0 0 0 5 1 a.png\n\n");
  folder.write("points3D.txt", "1 0.1 0.2 0.3 9 9 9 0.5 1 2 1 3\n");
  for (const char* where : {"", "cameras.txt", "images.txt"}) {
    const auto views = views_from({folder.at(where), "", ""});
    REQUIRE(views.size() == 1);
    CHECK(views[0].name == "a");
    CHECK(views[0].camera.intrinsics(0, 2) == 1.5);
  }
}

TEST_CASE("Bundler's principal point is the center of the image") {
  const Folder folder;
  folder.write("bundle.out", "# Bundle file v0.3\n1 0\n9 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 -5\n");
  folder.write("a.pgm", image(5, 4, 10));
  const auto views = views_from({folder.at("bundle.out"), folder.at("a.pgm"), ""});
  CHECK(views[0].camera.intrinsics(0, 2) == 2);
  CHECK(views[0].camera.intrinsics(1, 2) == 1.5);
}
