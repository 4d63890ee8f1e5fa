/// Folders of cameras and photographs, for tests of functions that read them.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "transformesh/errors.h"
#include "transformesh/views.h"
#include "views/cameras/view_files.h"

namespace transformesh::test {

/// A temporary folder of files, which the destructor removes.
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

/// A gray image whose pixels all have one intensity.
inline std::string image(int width, int height, int intensity) {
  return "P5 " + std::to_string(width) + " " + std::to_string(height) + " 255\n" +
         std::string(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                     static_cast<char>(intensity));
}

inline std::string middlebury(const std::vector<std::string>& names) {
  std::string text = std::to_string(names.size()) + "\n";
  int focal = 100;
  for (const std::string& name : names) {
    const std::string f = std::to_string(focal++);
    text += name + " " + f + " 0 2 0 " + f + " 1 0 0 1 1 0 0 0 1 0 0 0 1 0 0 5\n";
  }
  return text;
}

inline std::string refusal(const ViewSources& sources) {
  try {
    views_from(sources);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

inline bool says(const std::string& message, const std::string& what) {
  INFO(message);
  return message.find(what) != std::string::npos;
}

}  // namespace transformesh::test
