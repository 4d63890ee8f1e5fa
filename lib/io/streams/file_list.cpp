#include "io/streams/file_list.h"

#include <glob.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

#include "transformesh/errors.h"

namespace transformesh {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Removes the number at the start of the text and returns its digits without leading zeros.
std::string_view take_number(std::string_view& text) {
  std::string_view digits = text.substr(0, text.find_first_not_of("0123456789"));
  text.remove_prefix(digits.size());
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

template <typename Predicate>
std::vector<std::string> entries_of(const std::string& folder, const Predicate& is_wanted) {
  std::error_code error;
  std::vector<std::string> paths;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const bool is_hidden = entry->path().filename().string().starts_with('.');
    if (!is_hidden && is_wanted(*entry)) paths.push_back(entry->path().string());
  }
  if (error) throw InputError(folder + ": cannot be read: " + error.message());
  return paths;
}

std::vector<std::string> files_in(const std::string& folder) {
  std::error_code ignored;
  std::vector<std::string> files = entries_of(
      folder, [&](const fs::directory_entry& entry) { return entry.is_regular_file(ignored); });
  if (files.empty()) throw InputError(folder + ": there is no file in this folder");
  return files;
}

std::vector<std::string> matches_of(const std::string& pattern) {
  glob_t found{};
  const std::unique_ptr<glob_t, void (*)(glob_t*)> freed(&found, globfree);
  if (glob(pattern.c_str(), 0, nullptr, &found) != 0) return {};
  return {found.gl_pathv, found.gl_pathv + found.gl_pathc};
}

std::vector<std::string> files_matching(const std::string& pattern) {
  std::vector<std::string> files = matches_of(pattern);
  std::erase_if(files, [](const std::string& path) { return !is_file(path); });
  if (files.empty()) throw InputError(pattern + ": no file matches this pattern");
  return files;
}

[[noreturn]] void fail_to_find(const std::string& path) {
  std::error_code error;
  const bool is_missing = fs::status(path, error).type() == fs::file_type::not_found;
  throw InputError(path + (is_missing ? ": there is no such file or folder"
                                      : ": cannot be read: " + error.message()));
}

}  // namespace

bool is_folder(const std::string& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

/// Unlike fs::is_regular_file(), also true for pipes.
bool is_file(const std::string& path) {
  std::error_code error;
  return fs::exists(path, error) && !fs::is_directory(path, error);
}

bool is_natural_less(std::string_view first, std::string_view second) {
  const std::string_view whole_first = first;
  const std::string_view whole_second = second;
  while (!first.empty() && !second.empty()) {
    if (is_digit(first[0]) && is_digit(second[0])) {
      const std::string_view a = take_number(first);
      const std::string_view b = take_number(second);
      if (a.size() != b.size()) return a.size() < b.size();
      if (a != b) return a < b;
    } else {
      if (first[0] != second[0]) return first[0] < second[0];
      first.remove_prefix(1);
      second.remove_prefix(1);
    }
  }
  // Names that differ in leading zeros only, such as 1 and 01, are compared as text.
  if (first.empty() && second.empty()) return whole_first < whole_second;
  return first.empty();
}

std::vector<std::string> files_at(const std::string& where) {
  if (where.empty()) throw InputError("the name of a file is empty");
  if (is_file(where)) return {where};
  std::vector<std::string> files;
  if (is_folder(where)) {
    files = files_in(where);
  } else if (where.find_first_of("*?[") != std::string::npos) {
    files = files_matching(where);
  } else {
    fail_to_find(where);
  }
  std::sort(files.begin(), files.end(), is_natural_less);
  return files;
}

std::vector<std::string> folders_at(const std::string& where) {
  const auto is_kept = [](const fs::directory_entry& entry) { return is_folder(entry.path()); };
  std::vector<std::string> paths =
      is_folder(where) ? entries_of(where, is_kept) : matches_of(where);
  std::sort(paths.begin(), paths.end(), is_natural_less);
  return paths;
}

std::string file_bytes(const std::string& path, std::size_t limit) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  constexpr std::size_t block = std::size_t{1} << 16;  // bytes; affects time only
  while (file && bytes.size() < limit) {
    const std::size_t size = bytes.size();
    bytes.resize(size + std::min(block, limit - size));
    file.read(bytes.data() + size, static_cast<std::streamsize>(bytes.size() - size));
    bytes.resize(size + static_cast<std::size_t>(file.gcount()));
  }
  if (!file.is_open() || file.bad()) {
    throw InputError(path + ": cannot be read: " + std::strerror(errno));
  }
  return bytes;
}

std::string stem_of(std::string_view path) {
  const fs::path name = fs::path(path).filename();
  const std::string extension = name.extension().string();
  const bool is_number = extension.size() > 1 && is_digit(extension[1]);
  return (is_number ? name : name.stem()).string();
}

}  // namespace transformesh
