#include "views/cameras/image_orientations.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "helpers/encoded_images.h"
#include "helpers/view_folder.h"
#include "views/cameras/view.h"

using namespace transformesh;
using test::Folder;
using test::image;
using test::middlebury;
using test::refusal;
using test::says;

TEST_CASE("an Exif orientation is noted, or refused if cameras are for the turned pictures") {
  const Folder folder;
  // A TIFF directory as Exif data, with orientation 6, before the pixels of a JPEG.
  const std::string exif("Exif\0\0II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0", 28);
  const std::string jpeg = test::jpeg_of({}, 8, 6, test::noise(8 * 6 * 3));
  const std::string turned =
      jpeg.substr(0, 2) + std::string("\xff\xe1\0\x1e", 4) + exif + jpeg.substr(2);
  folder.write("images/a.jpg", turned);
  const std::string pose = "\n1 1 0 0 0 0 0 5 1 a.jpg\n\n";
  std::string notes;
  ViewSources sources{folder.at("model.txt"), folder.at("images"), ""};
  sources.on_note = [&](const std::string& note) { notes += note + "\n"; };
  folder.write("model.txt", "1 PINHOLE 8 6 9 9 4 3" + pose);
  CHECK(views_from(sources)[0].image.width == 8);
  CHECK(says(notes, "as their cameras were calibrated"));
  folder.write("model.txt", "1 PINHOLE 6 8 9 9 3 4" + pose);
  CHECK(says(refusal(sources), "mogrify -auto-orient"));
  notes.clear();
  folder.write("par.txt", middlebury({"a.jpg"}));
  sources.cameras = folder.at("par.txt");
  CHECK(views_from(sources).size() == 1);
  CHECK(says(notes, "mogrify -auto-orient"));
}
