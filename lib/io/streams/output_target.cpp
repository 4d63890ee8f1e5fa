#include "io/streams/output_target.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>

#include "transformesh/errors.h"

namespace transformesh {
namespace {

namespace fs = std::filesystem;

// Limits of Linux: number of bytes of a file name, and number of symbolic links in a path.
constexpr std::size_t longest_name = 255;
constexpr int most_links = 40;

// Returns the descriptor that a path such as /dev/fd/3 names.
std::optional<int> descriptor_named(std::string_view path) {
  if (path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view prefix : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(prefix)) continue;
    const std::string_view digits = path.substr(prefix.size());
    int number = 0;
    const auto [end, error] = std::from_chars(digits.begin(), digits.end(), number);
    if (error == std::errc() && end == digits.end() && number >= 0) return number;
  }
  return std::nullopt;
}

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

// Returns the FNV-1a hash of a text (Fowler, Noll & Vo).
std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  return hash;
}

}  // namespace

void throw_not_written(const std::string& path) {
  throw OutputError("cannot write " + (path == "-" ? "standard output" : "'" + path + "'") + ": " +
                    std::strerror(errno));
}

std::string end_of_links(const std::string& path) {
  fs::path place = path;
  for (int i = 0; i < most_links; ++i) {
    if (descriptor_named(place.native())) return place;
    std::error_code error;
    const fs::path link = fs::read_symlink(place, error);
    if (error) return place;
    place = place.parent_path() / link;
  }
  errno = ELOOP;
  throw_not_written(path);
}

std::string place_of(const std::string& path) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? path : place.string();
}

bool is_same_place(const std::string& first, const std::string& second) {
  return place_of(first) == place_of(second);
}

bool is_written_directly(const std::string& path) {
  if (descriptor_named(path) || path.starts_with("/proc/")) return true;
  struct stat status {};
  return stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

int open_directly(const std::string& path) {
  const auto number = descriptor_named(path);
  const int descriptor = number ? fcntl(*number, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)
                                : open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) throw_not_written(path);
  return descriptor;
}

std::string name_beside(const std::string& path, const std::string& prefix,
                        const std::string& suffix) {
  const std::size_t begin = path.rfind('/') + 1;  // 0 if there is no slash
  const std::string folder = path.substr(0, begin);
  std::string name = path.substr(begin);
  if (prefix.size() + name.size() + suffix.size() > longest_name) {
    const std::string number = std::to_string(hash_of(name));
    std::size_t end = longest_name - prefix.size() - suffix.size() - number.size();
    while (end > 0 && is_continuation(name[end])) --end;
    name.resize(end);
    name += number;
  }
  return folder + prefix + name + suffix;
}

}  // namespace transformesh
