#include "views/cameras/name_pairs.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/random.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

using Partners = std::vector<std::size_t>;

Partners pair(const std::vector<std::string>& first, const std::vector<std::string>& second,
              bool names_must_agree = false) {
  return pair_by_name({"image", "photos", first, {}}, {"silhouette", "masks", second, {}},
                      names_must_agree);
}

/// Returns the message with which pairing is refused.
std::string refusal(const std::vector<std::string>& first, const std::vector<std::string>& second,
                    bool names_must_agree = false) {
  try {
    pair(first, second, names_must_agree);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("equal stems are partners in any order, whatever folders and extensions") {
  CHECK(pair({"x/a.jpg", "x/b.jpg", "x/c.jpg"}, {"y/c.png", "y/a.pgm", "y/b.png"}) ==
        Partners{1, 2, 0});
  // A permutation of many names is found.
  test::Random random(5);
  std::vector<std::string> names;
  for (int i = 0; i < 50; ++i) names.push_back("view" + std::to_string(7 * i));
  std::vector<std::string> shuffled = names;
  for (std::size_t i = shuffled.size(); i-- > 1;) std::swap(shuffled[i], shuffled[random.below(i)]);
  const Partners partners = pair(names, shuffled);
  for (std::size_t i = 0; i < names.size(); ++i) CHECK(shuffled[partners[i]] == names[i]);
}

TEST_CASE("a suffix that a side shares is left out where no name has a partner with it") {
  CHECK(pair({"a1.png", "a2.png"}, {"a2-mask.png", "a1-mask.png"}) == Partners{1, 0});
  CHECK(pair({"a1_P.txt", "a2_P.txt"}, {"a1-mask.png", "a2-mask.png"}) == Partners{0, 1});
  // All names have partners because of the suffix; without it, two names would be equal.
  CHECK(pair({"a-left.png", "a-right.png"}, {"a-right.png", "a-left.png"}) == Partners{1, 0});
  // A suffix with a digit is a number, not a suffix.
  CHECK(pair({"a.png", "b.png"}, {"x-1.png", "x-2.png"}) == Partners{0, 1});
}

TEST_CASE("without a common name the order decides, unless names must agree") {
  CHECK(pair({"a.png", "b.png"}, {"y.png", "z.png"}) == Partners{0, 1});
  CHECK(
      refusal({"a.png", "b.png"}, {"y.png", "z.png"}, true) ==
      "a.png: there is no silhouette of this name in masks: either all names must agree, or none");
  CHECK(refusal({"a.png", "b.png"}, {"x.png", "y.png", "z.png"}) ==
        "there are 2 images, but 3 silhouettes (photos, masks)");
}

TEST_CASE("names of which only some have a partner are refused, from either side") {
  // Numbered from 0 on one side and from 1 on the other, all pairs would be shifted.
  CHECK(
      refusal({"v0.png", "v1.png"}, {"v1.png", "v2.png"}).find("v0.png: there is no silhouette") ==
      0);
  CHECK(refusal({"v1.png"}, {"v1.png", "v2.png"}) ==
        "v2.png: there is no image of this name in photos: 2 silhouettes, but 1 image");
}

TEST_CASE("where names are the same on both sides, their folders below the root count") {
  const NamedFiles cameras{"camera", "images.txt", {"left/1.jpg", "right/1.jpg", "left/2.jpg"}, {}};
  const NamedFiles images{
      "image", "p/in", {"p/in/left/1.png", "p/in/left/2.png", "p/in/right/1.png"}, {}, "p/in"};
  CHECK(pair_by_name(cameras, images, true) == Partners{0, 2, 1});
  CHECK(distinct_stems(images) == std::vector<std::string>{"left/1", "left/2", "right/1"});
  CHECK(distinct_stems({"image", "p", {"p/a/1.png", "p/b/2.png"}, {}, "p"}) ==
        std::vector<std::string>{"1", "2"});
  CHECK(distinct_stems({"image", "", {"../a/1.png", "/b/1.png", "c/../d/1.png"}, {}}) ==
        std::vector<std::string>{"1", "1", "d/1"});
}

TEST_CASE("two names of a side that are the same are refused, and sides without any") {
  CHECK(refusal({"x/a.png", "y/a.png"}, {"a.png", "b.png"}) ==
        "photos: two images have the same name: x/a.png and y/a.png");
  CHECK(refusal({}, {"a.png"}) == "0 images, but 1 silhouette");
  const NamedFiles cameras{
      "camera", "par.txt", {"a.png", "a.png"}, {"par.txt line 2", "par.txt line 3"}};
  CHECK_THROWS_WITH_AS(pair_by_name(cameras, cameras, false),
                       "par.txt: two cameras have the same name: a.png (par.txt line 2) and a.png "
                       "(par.txt line 3)",
                       InputError);
}
