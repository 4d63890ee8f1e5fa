#include <doctest/doctest.h>

#include "helpers/camera_texts.h"

using namespace transformesh;
using test::is_refused;
using test::refusal;

namespace {

const std::string identity = "1 0 0 0 1 0 0 0 1";
const std::string lens = "300 0 160 0 310 120 0 0 1";

std::string middlebury(const std::string& line) { return "1\n" + line + "\n"; }

}  // namespace

TEST_CASE("Middlebury: K, R and t as they stand there") {
  const auto list = parse_cameras("2\n\na.png " + lens + " " + identity + " 1 2 3\n" +
                                      "b.png 600 0 320 0 620 240 0 0 2 0 -1 0 1 0 0 0 0 1 0 0 4\n",
                                  "some.txt");
  REQUIRE(list.cameras.size() == 2);
  CHECK(list.names_images);
  CHECK(list.cameras[0].name == "a.png");
  CHECK(list.cameras[0].place == "some.txt line 3");
  CHECK(list.cameras[0].camera.intrinsics(1, 2) == 120);
  CHECK(list.cameras[0].camera.translation == Vec3(1, 2, 3));
  CHECK(list.cameras[1].camera.intrinsics(1, 1) == 310);
  CHECK(list.cameras[1].camera.rotation(0, 1) == -1);
}

TEST_CASE("Middlebury: every mistake is refused with its line") {
  const std::string good = "a.png " + lens + " " + identity + " 0 0 5";
  CHECK(refusal(middlebury(good)).empty());
  CHECK(is_refused("2\n" + good + "\n", "announces 2 cameras, but there are only 1", 3));
  CHECK(is_refused("1\n" + good + "\n" + good + "\n", "but there are more", 3));
  CHECK(is_refused("0\n", "no camera", 1));
  CHECK(is_refused(good + "\n", "first line", 1));
  CHECK(is_refused(middlebury("a.png " + lens + " " + identity + " 0 0"), "t3 of 'a.png'", 2));
  CHECK(is_refused(middlebury(good + " 7"), "more values", 2));
  CHECK(is_refused(middlebury("a.png " + lens + " 1 0 0 0 1 0 0 x 1 0 0 5"), "r32 of 'a.png'", 2));
  CHECK(is_refused(middlebury("a.png nan 0 160 0 310 120 0 0 1 " + identity + " 0 0 5"),
                   "k11 of 'a.png'", 2));
  CHECK(is_refused(middlebury("a.png " + lens + " " + identity + " 0 inf 5"), "t2 of 'a.png'", 2));
  CHECK(is_refused(middlebury("a.png 0 0 160 0 310 120 0 0 1 " + identity + " 0 0 5"),
                   "focal lengths", 2));
  CHECK(is_refused(middlebury("a.png 300 0 160 4 310 120 0 0 1 " + identity + " 0 0 5"), "k21", 2));
  CHECK(is_refused(middlebury("a.png " + lens + " 1 0 0 0 1 0 0 0 1.1 0 0 5"), "orthonormal", 2));
  CHECK(is_refused(middlebury("a.png " + lens + " 1 0 0 0 1 0 0 0 -1 0 0 5"), "reflection", 2));
  CHECK(refusal("2\n" + good + "\n" + good + "\n").find("line 3") != std::string::npos);
}
