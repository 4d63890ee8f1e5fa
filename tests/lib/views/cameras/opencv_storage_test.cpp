#include "views/cameras/opencv_storage.h"

#include <doctest/doctest.h>

using namespace transformesh;

TEST_CASE("entries of OpenCV's files: keys, suffixes and matrices, in YAML and XML") {
  const std::string yaml =
      "%YAML:1.0\n---\nimage_width: 320\nK_1: !!opencv-matrix\n   rows: 1\n   data: [ 1., 2 ]\n"
      "D: [ 3 ]\n";
  const std::string xml =
      "<?xml version=\"1.0\"?>\n<opencv_storage>\n<image_width>320</image_width>\n"
      "<K_1 type_id=\"opencv-matrix\"><rows>1</rows><data>1. 2</data></K_1>\n<D>3</D>\n"
      "</opencv_storage>\n";
  using Entries = OpencvStorage::Entries;
  for (const std::string& text : {yaml, xml}) {
    const Source source{text, "a"};
    const OpencvStorage first(source, "_1");
    CHECK(first.get({"M", "K"}) == Entries{1, 2});
    CHECK(first.side("image_width") == 320);
    CHECK_FALSE(first.find({"D"}).has_value());
    const OpencvStorage all(source);
    CHECK(all.get({"D"}) == Entries{3});
    CHECK_FALSE(all.find({"K"}).has_value());
    CHECK(all.side("D_") == 0);
    CHECK(all.matrix_keys() == std::vector<std::string>{"K_1"});
  }
}
