/// Reads entries of a file that OpenCV's FileStorage wrote as YAML or XML. Reference: OpenCV's
/// manual, "File input and output using XML / YAML / JSON files".
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/streams/source.h"

namespace transformesh {

class OpencvStorage {
 public:
  /// Largest number of cameras in a file. Camera rigs have hundreds of cameras at most. Without a
  /// limit, a file of a megabyte could take hours, because each entry requires a search of the
  /// file.
  static constexpr std::size_t most_cameras = 1000;

  using Entries = std::vector<double>;
  using Keys = std::initializer_list<const char*>;

  /// `suffix`, such as `_1`, is appended to all keys. It selects the entries of one camera in a
  /// file of several cameras.
  explicit OpencvStorage(const Source& source, std::string suffix = {});

  /// Returns the numbers of the first of `keys` that is in the file, or nothing if none is. Throws
  /// InputError if an entry is not a finite number.
  std::optional<Entries> find(Keys keys) const;
  /// Returns the numbers as find() does. Throws InputError, with the first key, if none of `keys`
  /// is in the file.
  Entries get(Keys keys) const;
  /// Returns the number of an entry, which must be between 1 and 1e9. Accepts the key with or
  /// without the suffix. Returns 0 if there is no such entry.
  int side(const char* key) const;
  /// Returns the keys of all matrices, in the order of the file. Throws InputError for more than
  /// `most_cameras`.
  std::vector<std::string> matrix_keys() const;

  [[noreturn]] void fail(const std::string& what) const { source_.fail(what); }

 private:
  std::size_t value_of(const std::string& key) const;
  std::optional<std::string_view> text_of(const std::string& key) const;
  Entries numbers_in(std::string_view text, const std::string& key) const;

  const Source& source_;
  std::string suffix_;
  bool is_xml_;
};

}  // namespace transformesh
