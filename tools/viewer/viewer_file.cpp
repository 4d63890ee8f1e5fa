#include "viewer/viewer_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "transformesh/errors.h"

namespace transformesh::tool {

std::string read_viewer() {
  // The relative path is the same in the build folder and in the installation.
  std::error_code ignored;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  const std::filesystem::path path =
      program.parent_path().parent_path() / "share" / "transformesh" / "viewer.html";
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw GoalError("the viewer is not installed ('" + path.string() +
                    "' not found): run scripts/setup --browser, then build and install again");
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace transformesh::tool
