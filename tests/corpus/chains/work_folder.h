/// The working folder of a chain's programs: temporary unless the chain is to be kept.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace chains {

class WorkFolder {
 public:
  /// Uses the folder `kept`. If the name is empty, makes a new folder that is removed with this
  /// object.
  explicit WorkFolder(const std::string& kept) : path_(kept), is_kept_(!kept.empty()) {
    if (!is_kept_) {
      std::string name = (std::filesystem::temp_directory_path() / "chains-XXXXXX").string();
      if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
      path_ = name;
    }
    std::filesystem::create_directories(path_);
  }
  ~WorkFolder() {
    if (!is_kept_) std::filesystem::remove_all(path_);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  bool is_kept() const { return is_kept_; }
  std::string operator/(const std::string& name) const { return path_ / name; }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
  }
  /// Returns the bytes of a file; empty if there is no such file.
  std::string read(const std::string& name) const {
    std::ifstream file(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  std::filesystem::path path_;
  bool is_kept_;
};

}  // namespace chains
