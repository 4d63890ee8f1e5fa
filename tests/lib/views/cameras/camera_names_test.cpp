#include "views/cameras/camera_names.h"

#include <doctest/doctest.h>

using namespace transformesh;

namespace {

std::vector<std::string> shortened(const std::vector<std::string>& names) {
  CameraList list;
  for (const std::string& name : names) list.cameras.emplace_back().name = name;
  remove_common_folder(list);
  std::vector<std::string> result;
  for (const CameraRecord& record : list.cameras) result.push_back(record.name);
  return result;
}

}  // namespace

TEST_CASE("the folder that all images share is removed from their names") {
  using Names = std::vector<std::string>;
  CHECK(shortened({"/home/a/1.jpg", "/home/a/2.jpg"}) == Names{"1.jpg", "2.jpg"});
  CHECK(shortened({"/home/left/1.jpg", "/home/right/1.jpg"}) == Names{"left/1.jpg", "right/1.jpg"});
  CHECK(shortened({"C:\\a\\1.jpg"}) == Names{"1.jpg"});
  CHECK(shortened({"/a/10.jpg", "/a/1/2.jpg"}) == Names{"10.jpg", "1/2.jpg"});
  CHECK(shortened({"1.jpg", "a/2.jpg"}) == Names{"1.jpg", "a/2.jpg"});
  CHECK(shortened({}).empty());
}
