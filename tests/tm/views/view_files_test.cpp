#include "tm/views/view_files.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "tm/support/error.h"

using namespace transformesh;

namespace {

/// A folder of files that goes with its object.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "view_files_XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string at(const std::string& name) const { return (path_ / name).string(); }
  void write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(at(name), std::ios::binary) << bytes;
  }

 private:
  std::filesystem::path path_;
};

// A grey image whose pixels all have one level.
std::string image(int width, int height, int level) {
  return "P5 " + std::to_string(width) + " " + std::to_string(height) + " 255\n" +
         std::string(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                     static_cast<char>(level));
}

// A 3x4 matrix whose camera has this focal length.
std::string matrix(int focal) {
  const std::string f = std::to_string(focal);
  return f + " 0 2 0\n0 " + f + " 1 0\n0 0 1 5\n";
}

std::string middlebury(const std::vector<std::string>& names) {
  std::string text = std::to_string(names.size()) + "\n";
  int focal = 100;
  for (const std::string& name : names) {
    const std::string f = std::to_string(focal++);
    text += name + " " + f + " 0 2 0 " + f + " 1 0 0 1 1 0 0 0 1 0 0 0 1 0 0 5\n";
  }
  return text;
}

std::string refusal(const ViewSources& sources) {
  try {
    views_from(sources);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool says(const std::string& message, const std::string& what) {
  INFO(message);
  return message.find(what) != std::string::npos;
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
