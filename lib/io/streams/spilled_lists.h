/// Several lists of indices that grow at the same time and are stored in an unnamed file instead of
/// memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace transformesh {

class SpilledLists {
 public:
  /// Creates `count` empty lists in an unnamed file in this folder, which disappears with the
  /// process. Throws OutputError.
  SpilledLists(std::string folder, std::size_t count);
  ~SpilledLists();
  SpilledLists(const SpilledLists&) = delete;
  SpilledLists& operator=(const SpilledLists&) = delete;

  /// Appends to a list. Throws OutputError, for example if the disk is full.
  void add(std::size_t list, std::uint32_t index);
  std::vector<std::uint32_t> read(std::size_t list) const;

 private:
  struct List {
    std::vector<std::uint32_t> last;     ///< indices not yet written to the file
    std::vector<std::uint64_t> offsets;  ///< offsets of the list's full blocks in the file
  };

  void write(List& list);

  std::string folder_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::vector<List> lists_;
};

}  // namespace transformesh
